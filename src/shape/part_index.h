// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the parts of a shape (pieces of a sweep, components of a blob, faces of a mesh) that a ray
// may meet or that a point may be in, by their boxes. Each part is named once, in the order of its
// number.
#pragma once

#include "base/short_list.h"
#include "index/settings.h"

#include <cmath>

namespace candelabra {

/// So many parts are asked one by one; more are found through an index.
inline constexpr std::size_t few_parts = 8;

/// Above this number of parts an index is built by several threads.
inline constexpr std::size_t many_parts = 20'000;

class PartIndex {
public:
    PartIndex() = default;
    /// Parts whose boxes are not finite() are near every ray.
    explicit PartIndex(std::vector<Box> boxes, const RayIndex& = {});

    /// Around all parts.
    const Box& bounds() const { return bounds_; }

    /// Calls take(part) for each part whose box the ray meets in the range.
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

    /// Calls take(part, range) for parts whose box the ray meets in the range, those in front
    /// first where they are apart. It may lower the end of the range to where it has met the
    /// part: what is behind that is left out.
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
        // A ray without length visits the leaves around its origin.
        for (const std::uint32_t i : near(Ray{point, Vec3(1)}, {0, 0}))
            if (contains(boxes_[i], point)) take(i);
    }

private:
    /// The parts in the leaves that the ray passes, in order.
    ShortList<std::uint32_t, 512> near(const Ray&, const Interval&) const;

    /// clip(ray, box, range) leaves something; `inverse` is 1 / the ray's direction.
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

    std::vector<Box> boxes_;  ///< a little larger than given, so that rounding loses nothing
    WideTree tree_;           ///< empty when the parts are few
    Box bounds_;
};

}  // namespace candelabra
