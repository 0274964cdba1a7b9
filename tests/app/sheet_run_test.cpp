// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sheet_run.h"

#include "picture/read.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A scene that is as bright everywhere as the variable Level says.
constexpr const char* even_scene =
    "#version 3.7; #ifndef (Level) #declare Level = 0; #end global_settings { assumed_gamma 1 } "
    "background { rgb <Level, clock, 0> } sphere { 0, 1 translate 1000*z }";

Image read_back(const Shell& shell, const std::string& name) {
    Diagnostics diagnostics;
    const auto image = read_picture(shell.path(name), diagnostics);
    REQUIRE(image);
    return *image;
}

}  // namespace

TEST_CASE("a contact sheet has the pictures in their places", "[app]") {
    Shell shell;
    shell.write("a.pov", even_scene);
    for (const char* const file : {"s.png", "s.exr"}) {
        CAPTURE(file);
        REQUIRE(shell({"-V", "--sheet", "2x2", "Level=0.2,0.5,0.8", "+W16", "+H12",
                       shell.path("a.pov"), "+O" + shell.path(file)}) == 0);
        const Image sheet = read_back(shell, file);
        CHECK(sheet.width == 2 * 16 + 2);
        CHECK(sheet.height == 2 * 12 + 2);
        CHECK(sheet.at(8, 6).r == Approx(0.2).epsilon(0.01));
        CHECK(sheet.at(26, 6).r == Approx(0.5).epsilon(0.01));
        CHECK(sheet.at(8, 20).r == Approx(0.8).epsilon(0.01));
        CHECK(sheet.at(26, 20).r == Approx(0.03).epsilon(0.05));
        CHECK(sheet.at(16, 6).g == Approx(0.03).epsilon(0.05));
    }
    // Nothing else remains beside the two scenes.
    CHECK(std::distance(std::filesystem::directory_iterator(shell.folder), {}) == 4);
}

TEST_CASE("two values of a contact sheet lie across and down", "[app]") {
    Shell shell;
    shell.write("a.pov", even_scene);
    REQUIRE(shell({"-V", shell.path("a.pov"), "--sheet", "2x2", "Level=0..1", "clock=0,0.5", "+W8",
                   "+H6", "+O" + shell.path("s.png")}) == 0);
    const Image sheet = read_back(shell, "s.png");
    const Rgb lower_right = sheet.at(14, 12);
    CHECK(lower_right.r == Approx(1).epsilon(0.01));
    CHECK(lower_right.g == Approx(0.5).epsilon(0.01));
}

TEST_CASE("a contact sheet keeps the options that follow, and tells its command", "[app]") {
    Shell shell;
    shell.write("a.pov", even_scene);
    REQUIRE(shell({shell.path("a.pov"), "--sheet", "2x1", "Level=0..1", "Width=8", "+H6",
                   "+O" + shell.path("s.png")}) == 0);
    CHECK(read_back(shell, "s.png").width == 2 * 8 + 2);
    CHECK_THAT(shell.content("s.png"), Catch::Contains("--sheet '2x1 Level=0..1'"));
    CHECK_THAT(shell.err, Catch::Contains("picture 2 of 2: Level = 1"));
}

TEST_CASE("pictures of a contact sheet give a warning once", "[app]") {
    Shell shell;
    REQUIRE(shell({shell.path("lit.pov"), "--sheet", "3x1 Size=0.5..1", "+W60", "+H20",
                   "+O" + shell.path("s.png")}) == 0);
    const std::size_t first = shell.err.find("warning[aspect]");
    REQUIRE(first != std::string::npos);
    CHECK(shell.err.find("warning[aspect]", first + 1) == std::string::npos);
}

TEST_CASE("a contact sheet that is stopped leaves nothing", "[app]") {
    Shell shell;
    shell.interrupts.take = [] { return Interrupt::stop; };
    CHECK(shell({shell.path("lit.pov"), "-V", "--sheet", "2x1 Size=0.5..1", "+W16", "+H12",
                 "+O" + shell.path("s.png")}) == exit_status::stopped);
    CHECK_FALSE(has(shell.err, "+C"));
    CHECK(std::distance(std::filesystem::directory_iterator(shell.folder), {}) == 1);
}

TEST_CASE("what does not go with a contact sheet is refused", "[app]") {
    Shell shell;
    shell.write("a.pov", even_scene);
    const std::vector<std::string> others[] = {{"+KFF3"},
                                               {"--shard", "1/2"},
                                               {"+C"},
                                               {"--layers", "depth"},
                                               {"--denoise"},
                                               {"+UA"},
                                               {"-F"},
                                               {"+O-"},
                                               {"--preview", "0"},
                                               {"--check"},
                                               {"--keep-state"}};
    for (const auto& other : others) {
        CAPTURE(other[0]);
        std::vector<std::string> words = {shell.path("a.pov"), "--sheet", "2x1 Level=0..1"};
        words.insert(words.end(), other.begin(), other.end());
        CHECK(shell(words) == exit_status::usage);
        CHECK_THAT(shell.err, Catch::Contains("sheet"));
    }
    CHECK(shell({shell.path("a.pov"), "--sheet", "2x1"}) == exit_status::usage);
    CHECK_THAT(shell.err, Catch::Contains("--sheet 4x3 Seed=1..12"));
}

}  // namespace candelabra
