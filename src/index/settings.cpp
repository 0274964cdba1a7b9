// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/settings.h"

#include "vocabulary/schema.h"

namespace candelabra {

namespace {

constexpr const char* node_help = "cost of holding a ray against the boxes of a node";
constexpr const char* group_help = "cost of testing a group of items";

}  // namespace

const ItemInfo KdTree::vocabulary = described<KdTree>([] {
    using F = Field<KdTree>;
    return schema<KdTree>(
        "kd_tree",
        {"Divides space by planes into cells, and has each item in all cells that it passes "
         "through.",
         "global_settings { index { kd_tree } }",
         "global_settings { index { kd_tree node_cost 0.5 group_cost 2 reference_cost 1 } }"},
        F{"node_cost", &KdTree::node_cost, item, node_help, between(0, 1000)},
        F{"group_cost", &KdTree::group_cost, item, group_help, between(0, 1000)},
        F{"reference_cost", &KdTree::reference_cost, item,
          "cost of having an item in one cell more, where few are divided", between(0, 1000)});
});

const ItemInfo BoundingBoxes::vocabulary = described<BoundingBoxes>([] {
    using F = Field<BoundingBoxes>;
    return schema<BoundingBoxes>(
        "bounding_boxes",
        {"Divides items into groups, whose boxes may overlap.",
         "global_settings { index { bounding_boxes } }",
         "global_settings { index { bounding_boxes node_cost 1 group_cost 2 } }"},
        F{"node_cost", &BoundingBoxes::node_cost, item, node_help, between(0, 1000)},
        F{"group_cost", &BoundingBoxes::group_cost, item, group_help, between(0, 1000)});
});

TreeSettings tree_settings(const RayIndex& index, int group) {
    if (const auto* kd = std::get_if<KdTree>(&index))
        return {Division::cells, kd->node_cost, kd->group_cost, kd->reference_cost, group};
    const auto& boxes = std::get<BoundingBoxes>(index);
    return {Division::boxes, boxes.node_cost, boxes.group_cost, 0, group};
}

}  // namespace candelabra
