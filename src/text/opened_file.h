// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files that a scene names, opened so that they cannot be replaced between check and use: links
// have been resolved in the path beforehand, none is followed any more, and all checks apply to the
// open handle. FileAccess decides which paths may be opened.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

namespace candelabra {

/// Owns a file descriptor and closes it on destruction.
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
    /// Releases the descriptor, which the caller must close.
    int release() { return std::exchange(descriptor_, -1); }

private:
    int descriptor_ = -1;
};

/// Opens an absolute path with these flags of open(2), without waiting for a pipe. No part of the
/// path may be a link. On failure, the result is not open and errno is set as by open(2).
OpenedFile open_without_links(const std::string& path, int flags);

/// Whether the path leads to a regular file, following links. Calls only stat(2).
bool is_regular_file(const std::string& path);

bool is_regular_file(const OpenedFile&);

/// Returns the content of a regular file of up to `most` bytes; nothing for other files.
std::optional<std::string> content_of(const OpenedFile&, std::size_t most);

/// Returns the content of a regular file or a pipe that the user names, following links; nothing
/// for other files. Those are not opened, or not read if one replaces the file in the meantime.
std::optional<std::string> content_of_file(const std::string& path,
                                           std::size_t most = std::string::npos);

}  // namespace candelabra
