// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/item_reader.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Case {
    const char* script;
    const char* complaint;
};

}  // namespace

TEST_CASE("values go to the fields of their place, promoted as in POV-Ray", "[reading]") {
    const Script done =
        run("#version 3.7; sphere { 2, 1 } sphere { <1, 2>, 0.5 } box { x, <1, 2, 3> } "
            "disc { 0, y, 2 } disc { 0, y, 2, 1 } cylinder { 0, y, 1 open } cone { 0, 1, y, 0 open "
            "off }");
    REQUIRE(done.text.empty());
    CHECK(done.shape<Sphere>(0).centre == Vec3(2, 2, 2));
    CHECK(done.shape<Sphere>(1).centre == Vec3(1, 2, 0));
    CHECK(done.shape<Cuboid>(2).corner1 == Vec3(1, 0, 0));
    CHECK(done.shape<Cuboid>(2).corner2 == Vec3(1, 2, 3));
    CHECK(done.shape<Disc>(3).hole == 0);
    CHECK(done.shape<Disc>(4).hole == 1);
    CHECK(done.shape<Cylinder>(5).open);
    CHECK_FALSE(done.shape<Cone>(6).open);
}

TEST_CASE("a number behind a switch switches; it is no value of the shape", "[reading]") {
    const Script done = run("#version 3.7; disc { 0, y, 2 hollow 1 } disc { 0, y, 2 hollow off }");
    REQUIRE(done.text.empty());
    CHECK(done.shape<Disc>(0).hole == 0);
    CHECK(done.object(0).hollow);
    CHECK_FALSE(done.object(1).hollow);
}

TEST_CASE("a word of a block means itself, though the scene has declared the name", "[reading]") {
    const Script done =
        run("#version 3.7; #declare max_depth = 5; #declare light_octree = 1; #declare "
            "representatives = 2; "
            "global_settings { light_sampler { light_octree { max_depth max_depth representatives "
            "3 paper } } }");
    REQUIRE(done.text.empty());
    const auto& octree = std::get<LightOctree>(done.scene.settings.light_sampler);
    CHECK(octree.max_depth == 5);
    CHECK(octree.representatives == 3);
}

TEST_CASE("each wrong value is told of once, with place and rule", "[reading]") {
    const auto [script, expected] = GENERATE(values<Case>({
        {"sphere { 0, 1, 2 }", "error wrong-count: `sphere` takes 2 values, but here is one more"},
        {"sphere { 0 }", "error missing: `sphere` needs `radius`"},
        {"cylinder { }", "error missing: `cylinder` needs `base`, `cap` and `radius`"},
        {"disc { 0, y }", "error missing: `disc` needs `radius`"},
        {"ovus { -1, 1 }",
         "error out-of-range: `bottom_radius` of `ovus` must be at least 0, but it is -1"},
        // What POV-Ray renders is a warning.
        {"superellipsoid { <0, 1> }",
         "warning no-effect: `exponents` of `superellipsoid` should be above 0, but it is 0: 0.001 "
         "counts"},
        {"sphere { 0, 0 }", "warning degenerate: this `sphere` is left out: its radius is 0"},
        {"sphere { 0, <1, 2, 3> }",
         "error wrong-type: `radius` of `sphere` must be a number, but it is a vector of 3"},
        {"sphere { rgb 1, 1 }",
         "error wrong-type: `centre` of `sphere` must be a vector of 3, but it is a colour"},
        {"sphere { <1, 2, 3, 4>, 1 }",
         "error wrong-count: `centre` of `sphere` must be a vector of 3, but it is a vector of 4"},
        {"sphere { \"here\", 1 }",
         "error wrong-type: `centre` of `sphere` must be a vector of 3, but it is a string"},
        {"sphere { 0, 1 translate }", "error missing: `translate` of `sphere` needs a vector"},
        {"sphere { 0, 1 translate rotate x }",
         "error missing: `translate` of `sphere` needs a vector"},
        {"global_settings { max_trace_level -1 }",
         "warning no-effect: `max_trace_level` of `global_settings` should be from 0 to 256, but "
         "it "
         "is -1: 0 counts"},
        {"global_settings { max_trace_level 300 }",
         "warning no-effect: `max_trace_level` of `global_settings` should be from 0 to 256, but "
         "it "
         "is 300: 256 counts"},
        {"sphere { 0, 1 interior { fade_distance -1 } }",
         "warning no-effect: `fade_distance` of `interior` should be at least 0, but it is -1: 0 "
         "counts"},
        {"sphere { 0, 1 finish { roughness 0 } }",
         "warning no-effect: `roughness` of `finish` should be above 0, but it is 0: 0.0001 "
         "counts"},
        {"julia_fractal { <-.1, 0, -.8, 0> precision 0 }",
         "warning no-effect: `precision` of `julia_fractal` should be above 0, but it is 0: 1 "
         "counts"},
        {"polygon { 4, 0, x, x + y, y + z/9 }",
         "warning degenerate: this `polygon` is left out: the corners of a "
         "`polygon` must lie in one plane"},
        {"polygon { 4, 0, x, 2*x, 0 }",
         "warning degenerate: this `polygon` is left out: a `polygon` needs "
         "three corners that are not on one line"},
        {"disc { 0, 0, 1 }",
         "warning degenerate: this `disc` is left out: a `disc` needs a normal "
         "with a length above 0 and below 1e150"},
        {"quadric { 0, 0, 0, -1 }",
         "warning degenerate: this `quadric` is left out: all its factors besides the constant "
         "are 0"},

        {"global_settings { max_trace_level 2.5 }",
         "warning no-effect: `max_trace_level` of `global_settings` is a whole number, and 2.5 "
         "counts as 2"},
        {"camera { angle -1 }",
         "error out-of-range: `angle` of `camera` must be at least 0, but it is -1"},
        {"global_settings { adc_bailout 1 adc_bailout 2 }",
         "warning duplicate: `adc_bailout` of `global_settings` is given again; this one counts"},
    }));
    CHECK(complaint(script) == expected);
}

TEST_CASE("a word that is not reserved may have a value with a sign", "[reading]") {
    CHECK(complaint("isosurface { function { x } polarity -1 contained_by { box { -1, 1 } } }") ==
          "nothing");
    CHECK(complaint("#declare polarity = 3; sphere { 0, polarity -1 }") == "nothing");
}

}  // namespace candelabra
