// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/index_slice.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::size_t count(const std::string& text, std::string_view part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("a slice of the index shows the cells in it, as the camera sees them", "[output]") {
    const std::string script =
        "camera { location -9*z look_at 0 }\n"
        "sphere { <-4, 2, 0>, 1 } sphere { <4, -2, 0>, 1 } sphere { <0, 0, -8>, 1 }\n"
        "sphere { <0, 0, 8>, 1 }\n";
    for (const RayIndex& index : {RayIndex(KdTree()), RayIndex(BoundingBoxes())}) {
        const SharedWorld world = world_of(script, index);
        const std::string drawn = index_slice(*world);
        CHECK(drawn.starts_with("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1000 600'>"));
        CHECK(drawn.ends_with("</svg>\n"));
    }
    // Each item is alone in its cell; the other cells lie before and behind the plane.
    KdTree fine;
    fine.node_cost = 0;
    fine.group_cost = 100;
    const std::string drawn = index_slice(*world_of(script, fine));
    CHECK(count(drawn, "<rect") == 2);
    CHECK(count(drawn, "<rect x='0' y='0' width='200' height='200'") == 1);
    CHECK(count(drawn, "<rect x='800' y='400' width='200' height='200'") == 1);
}

TEST_CASE("a world without anything to find has nothing to draw", "[output]") {
    CHECK(count(index_slice(*world_of("plane { y, 0 }")), "<rect") == 0);
}

}  // namespace candelabra
