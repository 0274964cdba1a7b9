// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/new_scene.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <filesystem>

namespace candelabra {

namespace {

const std::string library = CANDELABRA_SOURCE_DIR "/stdlib";

}  // namespace

TEST_CASE("each template is a scene that makes its picture without a warning") {
    const std::vector<std::string> names = scene_templates(library);
    CHECK(names == std::vector<std::string>{"flake", "leds", "room", "street", "studio"});
    Shell shell;
    shell.library = library;
    for (const std::string& name : names) {
        CAPTURE(name);
        const std::string scene = shell.path(name + ".pov"), picture = shell.path(name + ".png");
        REQUIRE(shell({"new", "--template", name, scene}) == exit_status::done);
        CHECK(has(shell.out, scene));
        CHECK(shell({scene, "+W16", "+H9", "--samples", "1", "-V", "+O" + picture}) ==
              exit_status::done);
        CHECK_FALSE(has(shell.err, "warning"));
        CHECK(std::filesystem::exists(picture));
    }
}

TEST_CASE("a new scene is the studio, and gets its ending") {
    Shell shell;
    shell.library = library;
    REQUIRE(shell({"new", shell.path("mine")}) == exit_status::done);
    CHECK(has(shell.content("mine.pov"), "A studio"));
    REQUIRE(shell({"new", "--template=room", shell.path("other.pov")}) == exit_status::done);
    CHECK(has(shell.content("other.pov"), "A room"));
}

TEST_CASE("a new scene overwrites nothing, and says what it cannot do") {
    Shell shell;
    shell.library = library;
    shell.write("mine.pov", "sphere { 0, 1 }\n");
    const std::string mine = shell.path("mine.pov"), next = shell.path("next.pov");
    CHECK(shell({"new", mine}) == exit_status::file);
    CHECK(has(shell.err, "exists already"));
    CHECK(shell.content("mine.pov") == "sphere { 0, 1 }\n");
    std::filesystem::create_symlink("nowhere.pov", shell.path("link.pov"));
    CHECK(shell({"new", shell.path("link.pov")}) == exit_status::file);
    CHECK_FALSE(std::filesystem::exists(shell.path("nowhere.pov")));
    CHECK(shell({"new", "--template", "palace", next}) == exit_status::usage);
    CHECK(has(shell.err, "there are flake, leds, room, street, studio"));
    CHECK(shell({"new", "--template", "../colors", next}) == exit_status::usage);
    CHECK(shell({"new", "--template"}) == exit_status::usage);
    CHECK(shell({"new"}) == exit_status::usage);
    CHECK(shell({"new", "--what", next}) == exit_status::usage);
    CHECK(shell({"new", mine, next}) == exit_status::usage);
    CHECK(shell({"new", shell.path("no/folder.pov")}) == exit_status::file);
    CHECK_FALSE(std::filesystem::exists(next));
}

}  // namespace candelabra
