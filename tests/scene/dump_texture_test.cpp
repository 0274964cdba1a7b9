// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/dump_texture.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string dumped(const std::string& pigment) {
    const Script done = run("#version 3.7; sphere { 0, 1 " + pigment + " }");
    INFO(pigment << '\n' << done.text);
    REQUIRE(done.text.empty());
    return dump(done.texture().pigment);
}

}  // namespace

TEST_CASE("a pigment is written so that it reads back as the same", "[scene]") {
    for (const std::string text : {
             "rgb 0.5",
             "checker rgb 1, rgb <1, 0, 0> scale 2",
             "brick brick_size <1, 2, 3> mortar 0.1",
             "gradient y color_map { [0.25 rgb 1] [1 rgbt <1, 0, 0, 0.5>] } rotate 45*z",
             "marble turbulence <0.5, 0, 0> octaves 3 omega 0.7 lambda 3 frequency 2 phase 0.1",
             "marble ramp_wave frequency 1",
             "checker frequency 1",
             "rgb 1 quick_color rgb <1, 0.5, 0>",
             "checker rgb 1, rgb 0 quick_color rgb 0.5 scale 2",
             "spiral1 5 poly_wave 2 noise_generator 3",
             "crackle form <1, 0, 0> metric 3 offset 0.1 solid",
             "magnet 2 julia <0.1, 0.2>, 30 exterior 2, 0.5 interior 1, 3",
             "magnet 1 mandel 25",
             "julia <0.3, 0.4>, 20 exponent 3",
             "slope { y, 0.1, 0.9 altitude z, 1, 2 }",
             "slope { point_at <1, 2, 3>, 0.2, 0.7 }",
             "bozo warp { repeat 2*x flip x } scale 3 warp { turbulence 0.5 octaves 2 } rotate x",
             "bozo warp { black_hole <1, 2, 3>, 4 strength 2 inverse } warp { planar x, 2 }",
             "average pigment_map { [1 rgb 1] [2 granite scale 0.5] } translate x",
             "hexagon pigment { rgb 1 } pigment { bozo scale 2 } pigment { rgb 0.2 }",
             "pigment_pattern { wood turbulence 0.1 } color_map { [0 rgb 0] [1 rgb 1] }",
         }) {
        const std::string once = dumped("pigment { " + text + " }");
        INFO(once);
        CHECK(dumped(once) == once);
    }
}

TEST_CASE("what a pattern has by itself is not written", "[scene]") {
    CHECK(dumped("pigment { checker rgb 1, rgb 0 }") == "pigment { checker rgb 1, rgb 0 }");
    CHECK(dumped("pigment { marble color_map { [0 rgb 1] } }") ==
          "pigment { marble color_map { [0 rgb 1] } }");
    CHECK(dumped("pigment { marble ramp_wave color_map { [0 rgb 1] } }") ==
          "pigment { marble ramp_wave color_map { [0 rgb 1] } }");
}

TEST_CASE("a normal is written so that it reads back as the same", "[scene]") {
    const auto dumped_normal = [](const std::string& normal) {
        const Script done = run("#version 3.7; sphere { 0, 1 " + normal + " }");
        INFO(normal << '\n' << done.text);
        REQUIRE(done.text.empty());
        return dump(done.texture().normal);
    };
    CHECK(dumped_normal("pigment { rgb 1 }").empty());
    for (const std::string text : {
             "bumps 0.7 scale 3",
             "gradient x, 0.1 accuracy 0.5 no_bump_scale slope_map { [0 <0, 1>] [1 <1, -2>] }",
             "average normal_map { [1 bumps 0.3] [2 dents scale 2] } rotate x",
             "checker normal { bumps } normal { ripples 2 frequency 3 }",
         }) {
        const std::string once = dumped_normal("normal { " + text + " }");
        INFO(once);
        CHECK(dumped_normal(once) == once);
    }
}

}  // namespace candelabra
