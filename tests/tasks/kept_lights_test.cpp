// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/kept_lights.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

struct Keeper : Shell {
    /// Renders with the light of lamps kept; returns the exit status.
    int keep(std::vector<std::string> more) {
        more.insert(more.end(), {"--keep-lights", path("lit.lights"), "-V"});
        return render(std::move(more));
    }
};

}  // namespace

TEST_CASE("keeping lights says what it does not go with", "[tasks]") {
    Keeper run;
    const std::string picture = "+O" + run.path("lit.png");
    const auto refused = [&](const std::vector<std::string>& more, std::string_view why) {
        INFO(why);
        std::vector<std::string> words = {picture};
        words.insert(words.end(), more.begin(), more.end());
        CHECK(run.keep(words) != 0);
        CHECK(has(run.err, why));
        CHECK(run.content("lit.lights") == "");
    };
    refused({"--shard", "1/2", "--samples", "4"}, "a shard by samples has some");
    refused({"--draft"}, "--draft averages it");
    CHECK(run({run.path("lit.pov"), picture, "-V", "+W640", "+H480", "--keep-lights",
               run.path("lit.lights"), "--keep-lights-size", "64K"}) == 2);
    CHECK(has(run.err, "the light of 1 lamp in a picture of 640x480 needs 6170 kB"));
    CHECK(run.render({picture, "-V", "--keep-lights-size", "1M"}) == 0);
    CHECK(has(run.err, "a file that nobody asks for"));
    run.write("dark.pov", "#version 3.7; camera { location -5*z } sphere { 0, 1 }");
    CHECK(run({run.path("dark.pov"), picture, "-V", "--keep-lights", run.path("dark.lights")}) !=
          0);
    CHECK(has(run.err, "has no lamps"));
    run.write("gamma.pov", "global_settings { assumed_gamma 2.2 }" + std::string(lit_scene));
    CHECK(run({run.path("gamma.pov"), picture, "-V", "+W8", "+H8", "--samples", "1",
               "--keep-lights", run.path("gamma.lights")}) != 0);
    CHECK(has(run.err, "assumed_gamma 1"));
    run.write("rays.pov",
              "#version 3.7; camera { location -5*z } sphere { 0, 1 pigment { rgb 1 } } "
              "light_source { -9*z, 1 }");
    CHECK(run({run.path("rays.pov"), picture, "-V", "+W8", "+H8", "+A", "--keep-lights",
               run.path("rays.lights")}) != 0);
    CHECK(has(run.err, "--samples 16"));
}

TEST_CASE("a run that is stopped while it reads meters says what it left", "[tasks]") {
    Keeper run;
    run.write("lit.pov",
              std::string(lit_scene) + "meter { \"M\" points { 2, <0, -0.9, 0>, <1, -0.9, 0> } }");
    const std::vector<std::string> way = {"+O" + run.path("lit.png"), "--samples", "9", "+C"};
    REQUIRE(run.keep(way) == 0);
    const std::string at_once = run.content("lit.png") + run.content("lit.lights");
    const fs::path state = run.path("lit.png.state.exr");
    const auto stop_after = [&](int questions) {
        int asked = 0;
        run.interrupts.take = [&] {
            return ++asked > questions ? Interrupt::stop : Interrupt::none;
        };
        CHECK(run.keep(way) == exit_status::stopped);
        const bool left = fs::exists(state);
        CHECK(has(run.err, "+C goes on from") == left);
        CHECK(has(run.err, "stopped before the first sample") == !left);
    };
    int questions = 0;
    for (; !fs::exists(state); ++questions) {
        REQUIRE(questions < 1000);
        stop_after(questions);
    }
    CHECK(questions > 1);
    // A state stays where the next run does not come to its samples.
    const std::string kept = run.content("lit.png.state.exr");
    stop_after(0);
    CHECK(run.content("lit.png.state.exr") == kept);
    run.interrupts.take = {};
    REQUIRE(run.keep(way) == 0);
    CHECK(run.content("lit.png") + run.content("lit.lights") == at_once);
}

TEST_CASE("kept lights do not begin in the middle of a picture", "[tasks]") {
    Keeper run;
    const std::string picture = "+O" + run.path("lit.png");
    REQUIRE(run.render({picture, "-V", "--keep-state"}) == 0);
    CHECK(run.keep({picture, "+C"}) != 0);
    CHECK(has(run.err, "whose light was not kept"));
    CHECK(run.keep({picture}) == 0);
    CHECK(run.content("lit.lights") != "");
}

TEST_CASE("kept lights have the bytes of any other run", "[tasks]") {
    Keeper run;
    const std::string picture = "+O" + run.path("lit.png");
    REQUIRE(run.keep({picture, "+WT1"}) == 0);
    const std::string once = run.content("lit.lights"), shown = run.content("lit.png");
    REQUIRE(run.keep({picture, "+WT3"}) == 0);
    CHECK(run.content("lit.lights") == once);
    REQUIRE(run.render({picture, "-V"}) == 0);
    CHECK(run.content("lit.png") == shown);
}

TEST_CASE("the report of light names lamps of an array that could be off", "[tasks]") {
    Keeper run;
    run.write("wall.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 1, 0> right 1.6*x up y angle 60 }
plane { y, 0 pigment { rgb 0.8 } finish { ambient 0 diffuse 0.8 } }
#declare Lamp = sphere { 0, 0.1 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 9 } }
#declare Facade = union { #for (I, 0, 11) object { Lamp translate <I - 5.5, 0.5, 0> } #end }
object { Facade }
// A box around three of the lamps.
difference { box { <-2, -1, -0.4>, <1, 1.2, 0.4> } box { <-1.9, -2, -0.3>, <0.9, 1.1, 0.3> }
             pigment { rgb 0.5 } finish { ambient 0 diffuse 0.5 } }
)");
    const std::string kept = run.path("wall.lights");
    const auto report = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {run.path("wall.pov"),
                                          "+O" + run.path("wall.png"),
                                          "-V",
                                          "+W32",
                                          "+H24",
                                          "--samples",
                                          "8"};
        words.insert(words.end(), more.begin(), more.end());
        CHECK(run(words) == 0);
        return run.err;
    };
    const std::string line =
        "could be off alone, since no pixel changes by 1/255 without it: Facade[4..6]\n";
    const std::string told = report({"--light-report", "--keep-lights", kept});
    INFO(told);
    CHECK(has(told, line));
    // A small file sums light of lamps by nodes; what no sample has met is known all the same.
    CHECK(
        has(report({"--light-report", "--keep-lights", kept, "--keep-lights-size", "64K"}), line));
    CHECK_FALSE(has(report({"--keep-lights", kept}), "could be off"));
    CHECK_FALSE(has(report({"--light-report"}), "could be off"));
}

TEST_CASE("frames of an animation keep their lights in numbered files", "[tasks]") {
    Keeper run;
    CHECK(run.keep({"+O" + run.path("lit.png"), "+KFF2"}) == 0);
    CHECK(run.content("lit1.lights") != "");
    CHECK(run.content("lit2.lights") != "");
}

}  // namespace candelabra
