// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/library.h"

#include "support/folder.h"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("the standard library lies beside an installed program, or where one says") {
    const fs::path folder =
        fs::temp_directory_path() / ("candelabra_library_test_" + std::to_string(::getpid()));
    const fs::path root = folder / "so/deep/that/nothing/is/near";
    fs::create_directories(root / "bin");
    fs::create_directories(root / "share/candelabra/stdlib");
    const std::string program = root / "bin/candelabra";
    CHECK_FALSE(standard_library(program, nullptr));

    std::ofstream(root / "share/candelabra/stdlib/colors.inc") << "// nothing\n";
    CHECK(standard_library(program, nullptr) == (root / "share/candelabra/stdlib").string());
    CHECK(standard_library(program, "/elsewhere") == "/elsewhere");
    CHECK(standard_library(program, "") == (root / "share/candelabra/stdlib").string());
    CHECK_FALSE(standard_library("", nullptr));
    fs::remove_all(folder);
}

TEST_CASE("a variable names libraries with colons between", "[app]") {
    CHECK(named_libraries(nullptr).empty());
    CHECK(named_libraries("").empty());
    CHECK(named_libraries("/a b:lib::/c:") == std::vector<std::string>{"/a b", "lib", "/c"});
}

TEST_CASE("a program knows its own file") { CHECK(fs::is_regular_file(own_path())); }

TEST_CASE("the settings of everybody come from the file that a variable names", "[app]") {
    CHECK(settings_file("mine.ini", nullptr) == "mine.ini");
    CHECK_FALSE(settings_file("", nullptr));
    CHECK_FALSE(settings_file(nullptr, "/no/such/home"));
    // A file in the current folder may have come with a scene.
    const fs::path before = fs::current_path();
    const Folder folder;
    folder.put("candelabra.ini", "Library_Path=/");
    folder.put("home/.config/candelabra/candelabra.ini", "");
    fs::current_path(folder.path());
    CHECK_FALSE(settings_file(nullptr, "/no/such/home"));
    CHECK(settings_file(nullptr, (folder / "home").c_str()) ==
          folder / "home/.config/candelabra/candelabra.ini");
    fs::current_path(before);
}

}  // namespace candelabra
