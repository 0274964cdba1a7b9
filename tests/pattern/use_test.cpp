// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/use.h"

#include "pattern/values.h"

namespace candelabra {

TEST_CASE("turbulence comes last on the way to the pattern, wherever it stands", "[pattern]") {
    const Vec3 point(0.3, 0.7, -0.2);
    const Vec3 expected = pattern_of("bozo scale 2 turbulence 0.5").place(point);
    CHECK(pattern_of("bozo turbulence 0.5 scale 2").place(point) == expected);
    CHECK(expected == point / 2.0 + 0.5 * turbulence(point / 2.0, {}));
    CHECK(pattern_of("bozo scale 2 warp { turbulence 0.5 }").place(point) != expected);
}

}  // namespace candelabra
