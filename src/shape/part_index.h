// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of a shape (pieces of a sweep, components of a blob, faces of a mesh) that a ray
// may meet or that a point may be in, by their boxes. Each part is named once, in the order of its
// number.
#pragma once

#include "index/kdtree.h"

#include <algorithm>

class PartIndex {
public:
    PartIndex() = default;
    /// The boxes are finite.
    explicit PartIndex(std::vector<Box> boxes);

    /// Around all parts.
    const Box& bounds() const { return bounds_; }

    /// Calls take(part) for each part whose box the ray meets in the range.
    template <class Take>
    void along(const Ray& ray, const Interval& range, Take take) const {
        if (tree_.nodes().empty()) {
            for (std::uint32_t i = 0; i < boxes_.size(); ++i)
                if (meets(ray, boxes_[i], range)) take(i);
            return;
        }
        std::vector<std::uint32_t> found;
        tree_.traverse(ray, range, [&](std::span<const std::uint32_t> items, Interval&) {
            found.insert(found.end(), items.begin(), items.end());
            return false;
        });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        for (const std::uint32_t i : found)
            if (meets(ray, boxes_[i], range)) take(i);
    }

    /// Calls take(part) for each part whose box contains the point.
    template <class Take>
    void around(const Vec3& point, Take take) const {
        if (!contains(bounds_, point)) return;
        if (tree_.nodes().empty()) {
            for (std::uint32_t i = 0; i < boxes_.size(); ++i)
                if (contains(boxes_[i], point)) take(i);
            return;
        }
        // A ray without length visits the cells at its origin, which may share items.
        std::vector<std::uint32_t> found;
        tree_.traverse(Ray{point, Vec3(1)}, {0, 0},
                       [&](std::span<const std::uint32_t> items, Interval&) {
                           found.insert(found.end(), items.begin(), items.end());
                           return false;
                       });
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        for (const std::uint32_t i : found)
            if (contains(boxes_[i], point)) take(i);
    }

private:
    static bool meets(const Ray& ray, const Box& box, const Interval& range) {
        const Interval within = clip(ray, box, range);
        return within.min <= within.max;
    }

    std::vector<Box> boxes_;  ///< a little larger than given, so that rounding loses nothing
    KdTree tree_;             ///< empty when the parts are few
    Box bounds_;
};
