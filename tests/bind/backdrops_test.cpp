// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/backdrops.h"

#include "support/script.h"

#include <catch2/catch.hpp>

#include <numbers>

namespace candelabra {

TEST_CASE("a sky has pigments, the last one counts of several", "[bind]") {
    const Script done =
        run("#version 3.7; #declare S = sky_sphere { pigment { rgb 1 } pigment { bozo } scale 2 } "
            "sky_sphere { pigment { rgb 0 } } sky_sphere { S emission rgb 3 } sphere { 0, 1 }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    REQUIRE(done.scene.sky);
    CHECK(done.scene.sky->pigments.size() == 2);
    CHECK(done.scene.sky->pigments[1].transform.point(Vec3(1)) == Vec3(2));
    CHECK(done.scene.sky->emission == Rgb(3));
}

TEST_CASE("a sky has its luminance by a formula", "[bind]") {
    const Script done = run(
        "#version 3.7; sky_luminance { overcast } sky_luminance { type 13 place <40.7, -74> date "
        "<2026, 6, 21> time 16.5 zone -4 north -z up y direct lux(50000) } sphere { 0, 1 }");
    CHECK(done.text.find("needs the sun") != std::string::npos);
    REQUIRE(done.scene.daylight);
    CHECK(done.scene.daylight->type == 13);
    CHECK(done.scene.daylight->zone == -4);
    CHECK(done.scene.daylight->north == Vec3(0, 0, -1));
    CHECK(done.scene.daylight->direct == Approx(50000 / (std::numbers::pi * 200)));
    CHECK(complaint("sky_luminance { clear sun <40, 180> pigment { rgb 1 } }").find("error") == 0);
    CHECK(complaint("sky_luminance { clear sun <40, 180> type 17 }") ==
          "error out-of-range: `type` of `sky_luminance` must be from 1 to 16, but it is 17");
    CHECK(complaint("#declare sky_luminance = 2; sphere { 0, sky_luminance }") == "nothing");
}

TEST_CASE("fogs add up", "[bind]") {
    const Script done =
        run("#version 3.7; fog { distance 5 color rgbt <1, 0, 0, 0.2> } fog { fog_type 2 rgb 1 "
            "distance "
            "3 fog_alt 2 fog_offset 1 turbulence 0.5 up z } sphere { 0, 1 }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    REQUIRE(done.scene.fogs.size() == 2);
    CHECK(done.scene.fogs[0].colour.transmit == 0.2);
    CHECK(done.scene.fogs[1].turbulence == Vec3(0.5));
    CHECK(complaint("fog { fog_type 3 }") ==
          "warning no-effect: `fog_type` of `fog` should be from 1 to 2, but it is 3: 2 counts");
    CHECK(complaint("fog { up 0 distance 1 }") == "nothing");
    CHECK(complaint("fog { fog_type 2 up 0 distance 1 fog_alt 1 }") ==
          "warning degenerate: `up` of `fog` is 0: as in POV-Ray, everything in this fog is black");
    CHECK(complaint("sky_sphere { }") == "error missing: `sky_sphere` needs a pigment");
}

}  // namespace candelabra
