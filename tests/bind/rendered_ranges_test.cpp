// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/rendered_ranges.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("numbers outside of a range are brought into it", "[bind]") {
    FieldValue value = Vec2(-1, 20);
    CHECK(bring_into(between(0, 10), {"a", "b", 3}, value) == 10);
    CHECK(std::get<Vec2>(value) == Vec2(3, 10));
    value = -2.0;
    CHECK(bring_into(at_least(0), {"a", "b", 0, true}, value) == 2);
    value = 5.0;
    bring_into(at_least(0), {"a", "b", 1}, value);
    CHECK(std::get<double>(value) == 5);
}

TEST_CASE("what POV-Ray renders outside of a range is a warning", "[bind]") {
    const std::string text =
        GENERATE("torus { -1, 0.3 }", "torus { 1, -0.3 }", "superellipsoid { <-0.5, 1> }",
                 "sphere_sweep { linear_spline 2, -x, 0.3, x, 0.3 tolerance 0 }",
                 "blob { threshold -1 sphere { 0, 1, 1 } }",
                 "julia_fractal { <-.1, 0, -.8, 0> max_iteration 0 }",
                 "polygon { 4, 0, x, x + y + z, y }", "fog { distance -3 } sphere { 0, 1 }",
                 "global_settings { number_of_waves 0 }", "sphere { 0, 1 interior { ior -1 } }",
                 "sphere { 0, 1 finish { reflection { 1 exponent 0 } } }",
                 "fog { distance 3 turbulence 0.3 octaves 20 }");
    INFO(text);
    const Script done = run("#version 3.7; " + text);
    INFO(done.text);
    CHECK(done.text.starts_with("warning"));
    CHECK(done.text.find("error") == std::string::npos);
}

TEST_CASE("what POV-Ray refuses is an error", "[bind]") {
    const std::string text =
        GENERATE("ovus { -1, 0.3 }", "poly { 1, <1, 0, 0, 0> }", "polygon { 2, 0, x }",
                 "sphere { 0, 1 interior { media { intervals 0 } } }", "plane { 0, 1 }",
                 "global_settings { radiosity { count 0 } }");
    INFO(text);
    CHECK(complaint(text).starts_with("error"));
}

}  // namespace candelabra
