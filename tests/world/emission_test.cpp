// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/emission.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("objects are dark when none of their parts can glow", "[world]") {
    const auto [script, dark] = GENERATE(table<std::string, bool>({
        {"sphere { 0, 1 pigment { rgb 1 } }", true},
        {"sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 phong 1 } }", true},
        {"sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }", false},
        {"union { sphere { 0, 1 } box { 0, 1 } pigment { rgb 1 } }", true},
        {"union { sphere { 0, 1 } box { 0, 1 } finish { emission 1 } }", false},
        {"union { sphere { 0, 1 } box { 0, 1 finish { emission 1 } } }", false},
        {"difference { box { 0, 1 } sphere { 0, 1 finish { emission <0, 1, 0> } } }", false},
        {"box { 0, 1 clipped_by { sphere { 0, 1 finish { emission 1 } } } }", false},
        {"box { 0, 1 pigment { checker } }", true},
    }));
    INFO(script);
    const Scene scene = scene_of(script);
    CHECK(cannot_emit(*scene.objects.at(0), nullptr) == dark);
}

TEST_CASE("what has no texture at all may glow", "[world]") {
    CHECK_FALSE(cannot_emit(Object{}, nullptr));
    const Handle<Texture> plain = make_handle<Texture>();
    CHECK(cannot_emit(Object{}, &plain));
}

}  // namespace candelabra
