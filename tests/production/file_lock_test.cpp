// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/file_lock.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <filesystem>

#include <unistd.h>

namespace candelabra {

TEST_CASE("one run at a time makes a file, and leaves no lock behind") {
    namespace fs = std::filesystem;
    const fs::path folder =
        fs::temp_directory_path() / ("candelabra_lock_" + std::to_string(::getpid()));
    fs::create_directory(folder);
    const std::string file = (folder / "a.png").string();
    {
        const FileLock first(file);
        CHECK_FALSE(first.taken());
        const FileLock second(file), other((folder / "b.png").string());
        CHECK(second.taken());
        CHECK_FALSE(other.taken());
    }
    CHECK(fs::is_empty(folder));
    CHECK_FALSE(FileLock(file).taken());
    CHECK_FALSE(FileLock("/no/such/folder/a.png").taken());
    CHECK_FALSE(FileLock("").taken());
    fs::remove_all(folder);
}

TEST_CASE("a lock follows no link") {
    const Folder folder;
    std::filesystem::create_symlink("none", folder / ".a.png.lock");
    const FileLock lock(folder / "a.png");
    CHECK_FALSE(lock.taken());
    CHECK_FALSE(std::filesystem::exists(folder / "none"));
}

TEST_CASE("a lock that a killed run has left locks nothing, and goes with the next run") {
    const Folder folder;
    folder.put(".a.png.lock", "");
    {
        const FileLock lock(folder / "a.png");
        CHECK_FALSE(lock.taken());
        CHECK(FileLock(folder / "a.png").taken());
    }
    CHECK_FALSE(std::filesystem::exists(folder / ".a.png.lock"));
}

}  // namespace candelabra
