// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/media_stack.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A stone in water in glass, from outside to inside: primitives 0, 1 and 2.
SharedWorld glass_of_water() {
    return world_of(R"(
        sphere { 0, 3 pigment { rgbt 1 } interior { ior 1.5 dispersion 1.1 dispersion_samples 5 } }
        sphere { 0, 2 pigment { rgbt 1 } interior { ior 1.2 } hollow }
        sphere { 0, 1 pigment { rgbt 1 } })");
}

}  // namespace

TEST_CASE("a surface bends light by the media on its two sides", "[transport]") {
    const SharedWorld world = glass_of_water();
    MediaStack media;
    CHECK(innermost(*world, media).ior == 1);
    CHECK(in_atmosphere(*world, media));
    const Interface glass = interface_at(*world, media, 0, {});
    CHECK(glass.ratio == Approx(1 / 1.5));
    CHECK(glass.bands == 5);
    const Interface water = interface_at(*world, glass.behind, 1, {});
    CHECK(water.ratio == Approx(1.5 / 1.2));
    CHECK(is_in(*world, water.behind, 0));
    CHECK_FALSE(is_in(*world, water.behind, 2));
    CHECK_FALSE(in_atmosphere(*world, water.behind));
    const Interface out = interface_at(*world, water.behind, 1, {});
    CHECK(out.ratio == Approx(1.2 / 1.5));
    CHECK(out.plain == 1);  // leaving one solid in another, as in POV-Ray
    CHECK(out.behind.size() == 1);
}

TEST_CASE("leaving one of two solids that overlap bends nothing", "[transport]") {
    const SharedWorld world = glass_of_water();
    const MediaStack both =
        interface_at(*world, interface_at(*world, {}, 0, {}).behind, 1, {}).behind;
    const Interface out = interface_at(*world, both, 0, {});
    CHECK(out.ratio == 1);
    REQUIRE(out.behind.size() == 1);
    CHECK(out.behind.back() == 1);
}

}  // namespace candelabra
