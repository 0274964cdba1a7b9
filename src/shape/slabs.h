// SPDX-License-Identifier: GPL-3.0-or-later
// Tests many boxes against one ray. Called by composites and the world before they test a shape; no
// hit in a box is lost to rounding.
#pragma once

#include "base/ray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

/// One ray for tests against boxes. As in clip(), NaN bounds nothing.
class Slabs {
public:
    explicit Slabs(const Ray& ray)
        : origin_(ray.origin),
          inverse_(Vec3(1) / ray.direction),
          size_(std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)})),
          backward_{std::signbit(inverse_.x), std::signbit(inverse_.y), std::signbit(inverse_.z)} {}

    bool miss(const Box& box, const Interval& range) const {
        const Interval left = within(box, range);
        return left.min > left.max;
    }

    /// The part of the range in the box, slightly enlarged against rounding errors; if there is
    /// none, it ends before it begins.
    Interval within(const Box& box, const Interval& range) const {
        double near = range.min, far = range.max;
        for (int axis = 0; axis < 3; ++axis) {
            const bool backward = backward_[static_cast<std::size_t>(axis)];
            const Vec3 &first = backward ? box.high : box.low,
                       &last = backward ? box.low : box.high;
            const double in = (first[axis] - origin_[axis]) * inverse_[axis];
            const double out = (last[axis] - origin_[axis]) * inverse_[axis];
            near = in > near ? in : near;
            far = out < far ? out : far;
        }
        const double rounding = 0.5e-9 * (size_ + std::abs(near));
        return {near - rounding, far + rounding};
    }

private:
    Vec3 origin_, inverse_;
    double size_;
    std::array<bool, 3> backward_;
};

}  // namespace candelabra
