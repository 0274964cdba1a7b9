// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/made_files.h"

#include "text/file_mark.h"
#include "text/sha256.h"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace candelabra {

namespace {

constexpr auto no_scene = "-";

/// Whether the file is regular and has no other hard link. A file that shares its content with
/// another name is not written to.
bool is_single(const struct stat& state) { return S_ISREG(state.st_mode) && state.st_nlink == 1; }

bool is_single(const OpenedFile& file) {
    struct stat state {};
    return ::fstat(file.descriptor(), &state) == 0 && is_single(state);
}

}  // namespace

MadeFiles::MadeFiles(const std::string& scene) {
    std::error_code failed;
    const bool complete = std::filesystem::path(scene).has_extension();
    const auto path = std::filesystem::canonical(scene + (complete ? "" : ".pov"), failed);
    mark_ = failed ? no_scene : sha256(path.string());
}

bool MadeFiles::has(const OpenedFile& file, const std::string& path) const {
    const std::string mark = mark_of(file);
    const bool own = mark_ != no_scene && mark == mark_;
    if (own || (!mark.empty() && path.ends_with(".tmp"))) return true;
    struct stat state {};
    const std::lock_guard lock(mutex_);
    return ::fstat(file.descriptor(), &state) == 0 && files_.contains({state.st_dev, state.st_ino});
}

void MadeFiles::add(const OpenedFile& file) {
    if (set_mark(file, mark_) && mark_ != no_scene) return;
    struct stat state {};
    const std::lock_guard lock(mutex_);
    if (::fstat(file.descriptor(), &state) == 0) files_.insert({state.st_dev, state.st_ino});
}

bool MadeFiles::may_write(const std::string& path, bool any) const {
    struct stat state {};
    if (::lstat(path.c_str(), &state) != 0) return errno == ENOENT || errno == ENOTDIR;
    if (!is_single(state)) return false;
    if (any) return true;
    const OpenedFile file = open_without_links(path, O_PATH);
    return file && has(file, path);
}

bool MadeFiles::made_by_another(const std::string& path) const {
    const OpenedFile file = open_without_links(path, O_PATH);
    return file && !mark_of(file).empty() && !has(file, path);
}

OpenedFile MadeFiles::open(const std::string& path, bool append, bool any) {
    if (OpenedFile made = open_without_links(path, O_WRONLY | O_CREAT | O_EXCL)) {
        add(made);
        return made;
    }
    if (errno != EEXIST || !may_write(path, any)) return {};
    OpenedFile file = open_without_links(path, O_WRONLY | (append ? O_APPEND : 0));
    const bool good = file && is_single(file) && (any || has(file, path)) &&
                      (append || ::ftruncate(file.descriptor(), 0) == 0);
    return good ? std::move(file) : OpenedFile();
}

}  // namespace candelabra
