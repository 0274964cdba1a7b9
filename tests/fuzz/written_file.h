// SPDX-License-Identifier: GPL-3.0-or-later
// A file with given bytes as long as the object lives.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace candelabra {

class WrittenFile {
public:
    WrittenFile(const std::uint8_t* data, std::size_t size, const std::string& ending) {
        const std::filesystem::path memory = "/dev/shm";
        const auto folder =
            std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
        path_ = (folder / ("candelabra-fuzz-" + std::to_string(::getpid()) + ending)).string();
        std::ofstream(path_, std::ios::binary)
            .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    }
    ~WrittenFile() { ::unlink(path_.c_str()); }
    WrittenFile(const WrittenFile&) = delete;
    WrittenFile& operator=(const WrittenFile&) = delete;

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace candelabra
