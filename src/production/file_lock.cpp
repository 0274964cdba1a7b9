// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/file_lock.h"

#include <cerrno>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace candelabra {

namespace {

/// Whether the open file is still the one at the path; its last owner may have removed it.
bool still_there(int file, const std::string& path) {
    struct stat open_one {};
    struct stat there {};
    return ::fstat(file, &open_one) == 0 && ::stat(path.c_str(), &there) == 0 &&
           open_one.st_ino == there.st_ino && open_one.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(const std::string& path) {
    if (path.empty()) return;
    const std::filesystem::path whole(path);
    path_ = (whole.parent_path() / ("." + whole.filename().string() + ".lock")).string();
    for (int attempt = 0; attempt < 10; ++attempt) {
        file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
        if (file_ < 0) return;
        if (::flock(file_, LOCK_EX | LOCK_NB) != 0)
            taken_ = errno == EWOULDBLOCK;
        else if (still_there(file_, path_))
            return;
        ::close(file_);
        file_ = -1;
        if (taken_) return;
    }
}

FileLock::~FileLock() {
    if (file_ < 0) return;
    ::unlink(path_.c_str());
    ::close(file_);
}

}  // namespace candelabra
