// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/similar_file.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <map>

namespace candelabra {

namespace {

const std::map<std::string, std::vector<std::string>> disk = {
    {"", {"Textures/", "data.txt", "my_wood.inc", "stones.inc"}},
    {"Textures", {"Marble.inc", "granite.inc"}},
    {"lib", {"colors.inc", "shapes.inc", "shapes.inc~"}},
    {"/", {"root.inc"}},
};

std::vector<std::string> listed(const std::string& folder) {
    const auto found = disk.find(folder);
    return found == disk.end() ? std::vector<std::string>() : found->second;
}

}  // namespace

TEST_CASE("a name that is nearly that of a file finds it", "[similar]") {
    struct Case {
        const char* name;
        const char* meant;
    };
    const Case cases[] = {
        {"COLORS.INC", "colors.inc"},
        {"colours.inc", "colors.inc"},
        {"Data", "data.txt"},
        {"data", "data.txt"},
        {"data.csv", "data.txt"},
        {"my wood.inc", "my_wood.inc"},
        {"mywood.inc", "my_wood.inc"},
        {"textures/marble.inc", "Textures/Marble.inc"},
        {"Textures\\Marble.inc", "Textures/Marble.inc"},
        {"Textures\\granite", "Textures/granite.inc"},
        {"./Textures//Granite.inc", "Textures/granite.inc"},
        {"shape.inc", "shapes.inc"},
        {"shape", "shapes.inc"},
        {"shape.png", ""},
        {"/Root.inc", "/root.inc"},
        {"nothing_like_it.inc", ""},
        {"nowhere/at_all.inc", ""},
        {"", ""},
        {"\\", ""},
    };
    for (const Case& c : cases) {
        INFO(c.name);
        CHECK(similar_file(c.name, {"", "lib"}, listed) == c.meant);
    }
}

TEST_CASE("the better likeness wins over the earlier folder", "[similar]") {
    const auto list = [](const std::string& folder) {
        return folder == "a" ? std::vector<std::string>{"stone.inc"}
                             : std::vector<std::string>{"Stones.inc"};
    };
    CHECK(similar_file("stones.inc", {"a", "b"}, list) == "Stones.inc");
}

TEST_CASE("the disk lister names files and folders in order", "[similar]") {
    const Folder folder;
    folder.put("b.inc", "");
    folder.put("a/x.inc", "");
    const Lister list = disk_lister();
    CHECK(list(folder.path().string()) == std::vector<std::string>{"a/", "b.inc"});
    CHECK(list(folder / "none").empty());
    CHECK(list(folder / "b.inc").empty());
}

}  // namespace candelabra
