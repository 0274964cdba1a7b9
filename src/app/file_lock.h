// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps two runs from making the same file at the same time. The lock is a hidden file beside it,
// which goes with the run, however that ends.
#pragma once

#include <string>

namespace candelabra {

class FileLock {
public:
    /// For the file at that path; none for an empty one.
    explicit FileLock(const std::string& path);
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// Another run has it. Where no lock can be made, nobody has it.
    bool taken() const { return taken_; }

private:
    std::string path_;
    int file_ = -1;
    bool taken_ = false;
};

}  // namespace candelabra
