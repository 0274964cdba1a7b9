// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/bicubic_patch.h"

#include "support/hits.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a patch of points in a plane is flat, and divided where it is not", "[shape]") {
    BicubicPatch sheet;
    CHECK(problem(sheet) == "a `bicubic_patch` needs a `type`, 0 or 1");
    sheet.type = 1;
    sheet.flatness = 0.01;
    sheet.u_steps = sheet.v_steps = 2;
    for (int i = 0; i < 16; ++i) sheet.points.push_back(Vec3(i % 4, 0, i / 4));
    CHECK(build(sheet).facets.size() == 2);
    const auto found = hits(build(sheet), {Vec3(1, 5, 2), Vec3(0, -1, 0)});
    REQUIRE(found.size() == 1);
    CHECK(found[0].normal == Vec3(0, 1, 0));
    for (const std::size_t i : {5u, 6u, 9u, 10u}) sheet.points[i].y = 2;
    const BuiltBicubicPatch curved = build(sheet);
    CHECK(curved.facets.size() == 32);
    // Flatness is measured from the plane through the first corner and its two neighbours.
    sheet.u_steps = 1;
    sheet.v_steps = 0;
    for (Vec3& point : sheet.points) point.y = 0;
    sheet.points[15].y = 1;
    sheet.flatness = 1.01;
    CHECK(build(sheet).facets.size() == 2);
    sheet.flatness = 0.99;
    CHECK(build(sheet).facets.size() == 4);
    CHECK(hits(curved, {Vec3(1.5, 5, 1.5), Vec3(0, -1, 0)}).at(0).t == Approx(5 - 1.125));
}

}  // namespace candelabra
