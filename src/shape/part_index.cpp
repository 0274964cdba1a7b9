// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/part_index.h"

#include <algorithm>

namespace {

/// So many boxes are tested one by one.
constexpr std::size_t few = 8;
constexpr std::size_t many = 20'000;

}  // namespace

PartIndex::PartIndex(std::vector<Box> boxes) : boxes_(std::move(boxes)) {
    for (const Box& box : boxes_) bounds_ = join(bounds_, box);
    const double size = bounds_.empty() ? 0
                                        : std::fmax(max_abs_component(bounds_.low),
                                                    max_abs_component(bounds_.high));
    for (Box& box : boxes_)
        if (!box.empty()) box = {box.low - 1e-12 * size, box.high + 1e-12 * size};
    if (boxes_.size() > few) tree_ = build_kdtree(boxes_, {}, {}, boxes_.size() > many ? 0 : 1);
}

ShortList<std::uint32_t, 512> PartIndex::in_cells(const Ray& ray, const Interval& range) const {
    ShortList<std::uint32_t, 512> found;
    tree_.traverse(ray, range, [&](std::span<const std::uint32_t> items, Interval&) {
        found.insert(found.end(), items.begin(), items.end());
        return false;
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}
