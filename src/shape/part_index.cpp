// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/part_index.h"

#include "base/long_work.h"
#include "index/tree_builder.h"

#include <algorithm>
#include <array>
#include <bit>

namespace candelabra {

namespace {

/// One bit for each part: for up to a few thousand parts this sorts them faster than std::sort.
class PartMarks {
public:
    static constexpr std::size_t most = 4096;

    explicit PartMarks(std::size_t parts) : words_((parts + 63) / 64) {
        std::fill_n(bits_.begin(), words_, 0);
    }
    void set(std::uint32_t part) { bits_[part / 64] |= std::uint64_t{1} << part % 64; }
    template <class List>
    void list(List& parts) const {
        for (std::uint32_t i = 0; i < words_; ++i)
            for (std::uint64_t left = bits_[i]; left != 0; left &= left - 1)
                parts.push_back(64 * i + static_cast<std::uint32_t>(std::countr_zero(left)));
    }

private:
    std::array<std::uint64_t, most / 64> bits_;  ///< of which the first words_ are in use
    std::size_t words_;
};

}  // namespace

PartIndex::PartIndex(std::vector<Box> boxes, const RayIndex& index) : boxes_(std::move(boxes)) {
    for (const Box& box : boxes_) bounds_ = join(bounds_, box);
    const double size = bounds_.empty() ? 0
                                        : std::fmax(max_abs_component(bounds_.low),
                                                    max_abs_component(bounds_.high));
    for (Box& box : boxes_)
        if (!box.empty()) box = {box.low - 1e-12 * size, box.high + 1e-12 * size};
    // Parts are tested one by one.
    if (boxes_.size() > few_parts)
        tree_ = build_tree(boxes_, tree_settings(index, 1), boxes_.size() > many_parts ? 0 : 1);
}

ShortList<std::uint32_t, 512> PartIndex::near(const Ray& ray, const Interval& range) const {
    ShortList<std::uint32_t, 512> found;
    if (boxes_.size() <= PartMarks::most) {
        PartMarks marks(boxes_.size());
        tree_.traverse(ray, range, [&](std::span<const std::uint32_t> items, Interval&) {
            for (const std::uint32_t item : items) marks.set(item);
            return false;
        });
        marks.list(found);
        count_long_work(found.size());
        return found;
    }
    tree_.traverse(ray, range, [&](std::span<const std::uint32_t> items, Interval&) {
        found.insert(found.end(), items.begin(), items.end());
        return false;
    });
    count_long_work(2 * found.size());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace candelabra
