// SPDX-License-Identifier: GPL-3.0-or-later
// A large block of zeros that takes memory only where it is used, or that lies in a file, so that
// it may be larger than the memory. Used by the film.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace candelabra {

class ZeroedPages {
public:
    ZeroedPages() = default;
    /// A block in memory. Pages that are never used take none. Throws std::bad_alloc.
    explicit ZeroedPages(std::size_t bytes);
    /// A block in memory of which little will be used. The system's limit on the memory of the
    /// process would count all of it, so it counts none. Throws std::bad_alloc.
    static ZeroedPages sparse(std::size_t bytes);
    /// A block in a file without a name in that folder, which ends with the block. Returns nothing
    /// if the folder does not permit it or has no room.
    static std::optional<ZeroedPages> in_file(const std::string& folder, std::size_t bytes);
    ~ZeroedPages();
    ZeroedPages(ZeroedPages&&) noexcept;
    ZeroedPages& operator=(ZeroedPages&&) noexcept;

    void* data() const { return begin_; }
    std::size_t size() const { return bytes_; }
    /// Leaves the contents to the file, until they are used again: then they take no memory that
    /// the system could not have back. Does nothing for a block in memory. Any thread may call it,
    /// while others use the block.
    void let_go() const;

private:
    ZeroedPages(void* begin, std::size_t bytes, bool in_file)
        : begin_(begin), bytes_(bytes), in_file_(in_file) {}

    void* begin_ = nullptr;
    std::size_t bytes_ = 0;
    bool in_file_ = false;
};

}  // namespace candelabra
