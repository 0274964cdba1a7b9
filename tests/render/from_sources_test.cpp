// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/lit.h"
#include "support/scripts.h"
#include "world/compile.h"

TEST_CASE("a point light gives POV-Ray's colour", "[render]") {
    const World world = world_of(R"(
        box { <-9, -1, -9>, <9, 0, 9> pigment { rgb 0.8 } finish { ambient 0 diffuse 0.5 } }
        light_source { <0, 4, 3>, rgb 2 }
        sphere { <0, 8, 6>, 1 }
    )");
    CHECK(mean_light(world, 1, 1) == Approx(0.8 * 0.5 * 2 * 0.8));
}
