// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/opened_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace candelabra {

namespace {

/// Returns the rest of the file, which is expected to have `expected` bytes; nothing if it is
/// longer than `most` or cannot be read.
std::optional<std::string> all_of(const OpenedFile& file, std::size_t expected, std::size_t most) {
    std::string text(expected + 1, '\0');  // the end is found without more room
    std::size_t filled = 0;
    for (;;) {
        // The file may have grown, and files of /proc report a size of 0.
        if (filled == text.size()) text.resize(std::max<std::size_t>(4096, filled + filled / 2));
        const ssize_t part = ::read(file.descriptor(), text.data() + filled, text.size() - filled);
        if (part < 0 && errno == EINTR) continue;
        if (part < 0) return std::nullopt;
        if (part == 0) break;
        filled += static_cast<std::size_t>(part);
        if (filled > most) return std::nullopt;
    }
    text.resize(filled);
    return text;
}

}  // namespace

OpenedFile::~OpenedFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

OpenedFile open_without_links(const std::string& path, int flags) {
    if (!path.starts_with('/') || path.find('\0') != path.npos) {
        errno = EINVAL;
        return {};
    }
    OpenedFile folder(::open("/", O_PATH | O_DIRECTORY | O_CLOEXEC));
    std::string_view rest = path;
    while (folder) {
        rest.remove_prefix(std::min(rest.find_first_not_of('/'), rest.size()));
        const std::size_t end = rest.find('/');
        const std::string part(rest.substr(0, end));
        if (end == rest.npos) {
            const int all = flags | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
            return OpenedFile(::openat(folder.descriptor(), part.c_str(), all, 0666));
        }
        rest.remove_prefix(end);
        const int through = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
        folder = OpenedFile(::openat(folder.descriptor(), part.c_str(), through));
    }
    return {};
}

bool is_regular_file(const std::string& path) {
    struct stat state {};
    return path.find('\0') == path.npos && ::stat(path.c_str(), &state) == 0 &&
           S_ISREG(state.st_mode);
}

bool is_regular_file(const OpenedFile& file) {
    struct stat state {};
    return ::fstat(file.descriptor(), &state) == 0 && S_ISREG(state.st_mode);
}

std::optional<std::string> content_of(const OpenedFile& file, std::size_t most) {
    struct stat state {};
    if (::fstat(file.descriptor(), &state) != 0 || !S_ISREG(state.st_mode)) return std::nullopt;
    if (static_cast<std::size_t>(state.st_size) > most) return std::nullopt;
    return all_of(file, static_cast<std::size_t>(state.st_size), most);
}

std::optional<std::string> content_of_file(const std::string& path, std::size_t most) {
    struct stat named {
    }, opened{};
    if (path.find('\0') != path.npos || ::stat(path.c_str(), &named) != 0) return std::nullopt;
    const bool regular = S_ISREG(named.st_mode);
    if (!regular && !S_ISFIFO(named.st_mode)) return std::nullopt;
    const int waits = regular ? O_NONBLOCK : 0;
    const OpenedFile file(::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC | waits));
    if (regular) return content_of(file, most);
    if (::fstat(file.descriptor(), &opened) != 0 || !S_ISFIFO(opened.st_mode)) return std::nullopt;
    return all_of(file, 0, most);
}

}  // namespace candelabra
