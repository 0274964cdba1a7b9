// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/settings.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the kd-tree is the first of both indexes, and the default", "[index]") {
    CHECK(Kinds<RayIndex>::infos[0]->name == "kd_tree");
    CHECK(Kinds<RayIndex>::infos[1]->name == "bounding_boxes");
    CHECK(std::holds_alternative<KdTree>(RayIndex()));
}

TEST_CASE("trees are built as the index says", "[index]") {
    const TreeSettings cells = tree_settings(KdTree{2, 3, 4}, 1);
    CHECK(cells.by == Division::cells);
    CHECK(cells.node_cost == 2);
    CHECK(cells.group_cost == 3);
    CHECK(cells.reference_cost == 4);
    CHECK(cells.group == 1);
    const TreeSettings boxes = tree_settings(BoundingBoxes{5, 6});
    CHECK(boxes.by == Division::boxes);
    CHECK(boxes.node_cost == 5);
    CHECK(boxes.group_cost == 6);
    CHECK(boxes.reference_cost == 0);
    CHECK(boxes.group == 8);
}

}  // namespace candelabra
