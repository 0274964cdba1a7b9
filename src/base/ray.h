// SPDX-License-Identifier: GPL-3.0-or-later
// Rays and their intersections.
#pragma once

#include "base/box.h"
#include "base/infinity.h"
#include "base/vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace candelabra {

/// A half line: origin + t * direction. The direction may have any length; t is in units of it.
struct Ray {
    Vec3 origin;
    Vec3 direction;

    Vec3 at(double t) const { return origin + t * direction; }
};

/// Range of ray parameters, open at both ends.
struct Interval {
    double min = 0;
    double max = infinity;

    bool contains(double t) const { return t > min && t < max; }
};

/// The line through the ray's origin, in both directions.
inline constexpr Interval whole_line{-infinity, infinity};

/// Returns the part of the interval in which the ray is inside the box; empty (min > max) if it
/// misses. A ray in one of the box's planes gives NaN there, which the order of the comparisons
/// ignores.
inline Interval clip(const Ray& ray, const Box& box, Interval range) {
    for (int axis = 0; axis < 3; ++axis) {
        const double inverse = 1 / ray.direction[axis];
        double near = (box.low[axis] - ray.origin[axis]) * inverse;
        double far = (box.high[axis] - ray.origin[axis]) * inverse;
        if (std::signbit(inverse)) std::swap(near, far);
        range.min = near > range.min ? near : range.min;
        range.max = far < range.max ? far : range.max;
    }
    return range;
}

/// One point where a ray crosses a surface.
struct Crossing {
    double t = 0;
    /// Unit, outward; for surfaces without an inside: as defined by the shape.
    Vec3 normal = Vec3(0);
    bool entering = true;    ///< the ray goes from outside to inside
    std::uint32_t part = 0;  ///< the part of the shape: the face of a mesh
};

/// All crossings of one ray with one shape, in any order. The first few need no heap memory.
class Crossings {
public:
    // The array is uninitialised: most rays that test a shape find few crossings or none.
    Crossings() {}
    Crossings(const Crossings&) = delete;
    Crossings& operator=(const Crossings&) = delete;
    ~Crossings() {}

    void add(const Crossing& crossing) {
        if (count_ >= inline_.size()) {
            spilled_.push_back(crossing);
        } else {
            // Copied by field, so that the argument need not be assembled in memory first.
            Crossing& free = inline_[count_];
            free.t = crossing.t;
            free.normal = crossing.normal;
            free.entering = crossing.entering;
            free.part = crossing.part;
        }
        ++count_;
    }
    void clear() {
        count_ = 0;
        spilled_.clear();
    }
    std::size_t size() const { return count_; }
    bool empty() const { return count_ == 0; }
    const Crossing& operator[](std::size_t i) const {
        return i < inline_.size() ? inline_[i] : spilled_[i - inline_.size()];
    }

private:
    union {
        std::array<Crossing, 4> inline_;
    };
    std::vector<Crossing> spilled_;
    std::size_t count_ = 0;
};

}  // namespace candelabra
