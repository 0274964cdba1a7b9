// SPDX-License-Identifier: GPL-3.0-or-later
// A folder on the disk for one test, gone at its end.
#pragma once

#include <filesystem>
#include <string>

namespace candelabra {

class Folder {
public:
    Folder();
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string operator/(const std::string& name) const { return (path_ / name).string(); }

    /// Writes a file, with the folders that lead to it.
    void put(const std::string& name, const std::string& text) const;
    /// What is in a file; nothing if there is none.
    std::string get(const std::string& name) const;

private:
    std::filesystem::path path_;
};

}  // namespace candelabra
