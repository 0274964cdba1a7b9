// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files that a scene names, opened so that nobody can put another one in their place meanwhile: the
// path is one that links have been taken out of, none is followed any more, and the handle is what
// gets checked and used. FileAccess decides which paths these are.

#include <optional>
#include <string>
#include <utility>

namespace candelabra {

/// A file descriptor of one's own; closed at the end.
class OpenedFile {
public:
    OpenedFile() = default;
    explicit OpenedFile(int descriptor) : descriptor_(descriptor) {}
    OpenedFile(OpenedFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    OpenedFile& operator=(OpenedFile&& other) noexcept {
        std::swap(descriptor_, other.descriptor_);
        return *this;
    }
    ~OpenedFile();

    explicit operator bool() const { return descriptor_ >= 0; }
    int descriptor() const { return descriptor_; }
    /// Whoever takes it closes it.
    int release() { return std::exchange(descriptor_, -1); }

private:
    int descriptor_ = -1;
};

/// Opens an absolute path with these flags of open(2); no part of it may be a link. Waits for no
/// pipe. Not open, with errno as open(2) leaves it, when that fails.
OpenedFile open_without_links(const std::string& path, int flags);

/// Whether there is a regular file at the path, links followed. Asks stat(2) only.
bool is_regular_file(const std::string& path);

/// Whether the handle is that of a regular file.
bool is_regular_file(const OpenedFile&);

/// All that is in a regular file of up to `most` bytes; nothing for others.
std::optional<std::string> content_of(const OpenedFile&, std::size_t most);

/// All that is in a regular file or a pipe that the user names, links followed; nothing for others,
/// which are not opened, or are left alone if they come into the file's place meanwhile.
std::optional<std::string> content_of_file(const std::string& path,
                                           std::size_t most = std::string::npos);

}  // namespace candelabra
