// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/file_mark.h"

#include <array>
#include <cerrno>
#include <cstddef>

#include <sys/xattr.h>

namespace candelabra {

namespace {

constexpr auto mark_name = "user.candelabra.scene";

}  // namespace

std::string mark_of(const OpenedFile& file) {
    // Read the attribute through /proc, since it cannot be read from an O_PATH handle.
    const std::string link = "/proc/self/fd/" + std::to_string(file.descriptor());
    std::array<char, 128> mark;
    const ssize_t size = ::getxattr(link.c_str(), mark_name, mark.data(), mark.size());
    // A mark that is too long is no scene's, but a mark.
    if (size < 0 && errno == ERANGE) return "?";
    return {mark.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
}

bool set_mark(const OpenedFile& file, const std::string& mark) {
    return ::fsetxattr(file.descriptor(), mark_name, mark.data(), mark.size(), 0) == 0;
}

}  // namespace candelabra
