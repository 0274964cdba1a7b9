// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of a shape (pieces of a sweep, components of a blob, faces of a mesh) that a ray
// may hit or that may contain a point, by their boxes. along() and around() report each part once,
// in ascending order.
#pragma once

#include "base/short_list.h"
#include "index/settings.h"

#include <cmath>

namespace candelabra {

/// Up to this number, parts are tested one by one; above it, an index is used.
inline constexpr std::size_t few_parts = 8;

/// Above this number of parts, several threads build the index.
inline constexpr std::size_t many_parts = 20'000;

class PartIndex {
public:
    PartIndex() = default;
    /// Parts whose boxes are not finite() are near every ray.
    explicit PartIndex(std::vector<Box> boxes, const RayIndex& = {});

    /// Bounds of all parts.
    const Box& bounds() const { return bounds_; }

    /// Calls take(part) for each part whose box the ray hits in the range.
    template <class Take>
    void along(const Ray& ray, const Interval& range, Take take) const {
        const Vec3 inverse = Vec3(1) / ray.direction;
        if (tree_.nodes().empty()) {
            for (std::uint32_t i = 0; i < boxes_.size(); ++i)
                if (meets(ray, inverse, boxes_[i], range)) take(i);
            return;
        }
        for (const std::uint32_t i : near(ray, range))
            if (meets(ray, inverse, boxes_[i], range)) take(i);
    }

    /// Calls take(part, range) for parts whose box the ray hits in the range, from front to back
    /// where they are apart. It may lower the end of the range to its hit; parts behind that are
    /// skipped.
    template <class Take>
    void nearest(const Ray& ray, Interval range, Take take) const {
        const Vec3 inverse = Vec3(1) / ray.direction;
        const auto ask = [&](std::uint32_t i, Interval& left) {
            if (meets(ray, inverse, boxes_[i], left)) take(i, left);
        };
        if (tree_.nodes().empty())
            for (std::uint32_t i = 0; i < boxes_.size(); ++i) ask(i, range);
        tree_.traverse(ray, range, [&](std::span<const std::uint32_t> parts, Interval& left) {
            for (const std::uint32_t i : parts) ask(i, left);
            return false;
        });
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
        // A ray of length 0 visits the leaves around its origin.
        for (const std::uint32_t i : near(Ray{point, Vec3(1)}, {0, 0}))
            if (contains(boxes_[i], point)) take(i);
    }

private:
    /// The parts in the leaves that the ray passes, in ascending order.
    ShortList<std::uint32_t, 512> near(const Ray&, const Interval&) const;

    /// Whether clip(ray, box, range) is not empty; `inverse` is 1 / the ray's direction.
    static bool meets(const Ray& ray, const Vec3& inverse, const Box& box, Interval range) {
        for (int axis = 0; axis < 3; ++axis) {
            const bool back = std::signbit(inverse[axis]);
            const double low = (box.low[axis] - ray.origin[axis]) * inverse[axis];
            const double high = (box.high[axis] - ray.origin[axis]) * inverse[axis];
            const double near = back ? high : low, far = back ? low : high;
            range.min = near > range.min ? near : range.min;
            range.max = far < range.max ? far : range.max;
        }
        return range.min <= range.max;
    }

    std::vector<Box> boxes_;  ///< slightly enlarged against rounding
    WideTree tree_;           ///< empty when there are few parts
    Box bounds_;
};

}  // namespace candelabra
