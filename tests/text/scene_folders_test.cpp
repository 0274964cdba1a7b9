// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/scene_folders.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

/// Folders as they are found from another current directory.
SceneFolders folders_in(const std::string& here, const std::string& scene,
                        const std::string& picture = {}) {
    const fs::path before = fs::current_path();
    fs::current_path(here);
    SceneFolders found = scene_folders(scene, picture);
    fs::current_path(before);
    return found;
}

bool has_folder(const std::vector<std::string>& list, const std::string& folder) {
    return std::ranges::find(list, fs::canonical(folder).string()) != list.end();
}

}  // namespace

TEST_CASE("homes, the whole disk and the system's folders are wide", "[file_access]") {
    const char* const home = std::getenv("HOME");
    for (const std::string folder : {"/", "/home", "/home/anyone", "/root", "/proc", "/proc/self",
                                     "/sys", "/dev", "/dev/fd", home && *home ? home : "/"}) {
        INFO(folder);
        CHECK(is_wide(folder));
    }
    for (const char* folder : {"/home/anyone/scenes", "/srv/job", "/dev/shm/job", "/tmp"})
        CHECK_FALSE(is_wide(folder));
}

TEST_CASE("the current folder is read only where the scene lies in or below it, and is not wide",
          "[file_access]") {
    const Folder folder;
    fs::create_directories(folder / "project/scenes");
    fs::create_directories(folder / "evil");
    const SceneFolders below = folders_in(folder / "project", "scenes");
    CHECK(has_folder(below.whole, folder / "project"));
    CHECK(has_folder(below.whole, folder / "project/scenes"));
    const SceneFolders beside = folders_in(folder / "project", "../evil", "x.png");
    CHECK_FALSE(has_folder(beside.whole, folder / "project"));
    CHECK(has_folder(beside.whole, folder / "evil"));
    REQUIRE(beside.files.size() == 1);
    CHECK(beside.files[0].has("x.png"));
    CHECK(beside.files[0].has("x12.layers.exr"));
    CHECK_FALSE(beside.files[0].has("xy.png"));
    const SceneFolders root = folders_in("/", folder / "evil");
    CHECK(root.whole.size() == 1);
    CHECK(root.left_out == "/");
    CHECK(folders_in(folder / "project", "").whole.size() == 1);
}

TEST_CASE("of a wide folder only the files in it are read, and nothing of the system",
          "[file_access]") {
    const SceneFolders root = scene_folders("/", "/a.png");
    CHECK(root.whole.empty());
    REQUIRE_FALSE(root.files.empty());
    CHECK(root.files[0].folder == "/");
    for (const char* folder : {"/proc/self", "/dev", "/sys/kernel"}) {
        const SceneFolders system = scene_folders(folder, std::string(folder) + "/a.png");
        CHECK(system.whole.empty());
        CHECK(system.files.empty());
    }
}

TEST_CASE("the folder of the picture is read if the scene lies there, else pictures of its name",
          "[file_access]") {
    const Folder folder;
    fs::create_directories(folder / "job/scenes");
    fs::create_directories(folder / "out");
    const std::string scene = folder / "job/scenes";
    CHECK(has_folder(scene_folders(scene, folder / "job/a.png").whole, folder / "job"));
    const SceneFolders other = scene_folders(scene, folder / "out/a.png");
    CHECK_FALSE(has_folder(other.whole, folder / "out"));
    REQUIRE(other.files.size() == 1);
    CHECK(other.files[0].stem == "a");
}

}  // namespace candelabra
