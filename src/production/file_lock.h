// SPDX-License-Identifier: GPL-3.0-or-later
// Prevents two runs from making the same file at the same time. The lock is a hidden file beside
// it. The lock ends with the run, however the run ends; the file stays if the run is killed, and
// the next run of the same picture takes it and removes it.
#pragma once

#include <string>

namespace candelabra {

class FileLock {
public:
    /// Locks the file at that path; an empty path locks nothing.
    explicit FileLock(const std::string& path);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// Whether another run holds the lock. False where no lock can be made.
    bool taken() const { return taken_; }

private:
    std::string path_;
    int file_ = -1;
    bool taken_ = false;
};

}  // namespace candelabra
