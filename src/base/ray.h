// SPDX-License-Identifier: GPL-3.0-or-later
// Rays and what they meet.
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

/// Half line: origin + t * direction. The direction need not have length 1; t is measured in its
/// lengths.
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

/// The part of the interval in which the ray is inside the box; empty (min > max) when it misses.
/// A ray that runs along one of the box's planes gives NaN there, which the order of the
/// comparisons ignores.
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
    bool entering = true;    ///< the ray goes from outside to inside here
    std::uint32_t part = 0;  ///< which piece of the shape it is: the face of a mesh
};

/// All crossings of one ray with one shape, in any order. The first few need no memory from the
/// heap.
class Crossings {
public:
    // What is not counted is not initialised: most rays that ask a shape find nothing, or little.
    Crossings() {}
    Crossings(const Crossings&) = delete;
    Crossings& operator=(const Crossings&) = delete;
    ~Crossings() {}

    void add(const Crossing& crossing) {
        if (count_ >= inline_.size()) {
            spilled_.push_back(crossing);
        } else {
            // Field by field, so that the argument need not be put together in memory first.
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
