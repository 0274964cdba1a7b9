// SPDX-License-Identifier: GPL-3.0-or-later
// Axis-aligned boxes: the only geometry that the index structures use.
#pragma once

#include "base/vector.h"

#include <limits>

namespace candelabra {

/// Closed axis-aligned box. Empty (the default) when low exceeds high on any axis.
struct Box {
    Vec3 low = Vec3(std::numeric_limits<double>::infinity());
    Vec3 high = Vec3(-std::numeric_limits<double>::infinity());

    bool empty() const { return low.x > high.x || low.y > high.y || low.z > high.z; }
    Vec3 centre() const { return 0.5 * (low + high); }
    Vec3 size() const { return high - low; }
};

/// The box of an unbounded object.
inline Box everywhere() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {Vec3(-infinity), Vec3(infinity)};
}

inline Box join(const Box& a, const Box& b) {
    return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}
inline Box join(const Box& a, const Vec3& p) { return {glm::min(a.low, p), glm::max(a.high, p)}; }
inline Box clip(const Box& a, const Box& b) {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

/// Surface area; 0 when empty.
inline double area(const Box& b) {
    if (b.empty()) return 0;
    const Vec3 s = b.size();
    return 2 * (s.x * s.y + s.y * s.z + s.z * s.x);
}

inline bool contains(const Box& b, const Vec3& p) {
    return glm::all(glm::lessThanEqual(b.low, p)) && glm::all(glm::lessThanEqual(p, b.high));
}

/// Squared distance from p to the nearest point of b (0 inside), and to its farthest corner.
inline double nearest_distance2(const Box& b, const Vec3& p) {
    const Vec3 gap = glm::max(glm::max(b.low - p, p - b.high), Vec3(0));
    return dot(gap, gap);
}
inline double farthest_distance2(const Box& b, const Vec3& p) {
    const Vec3 far = glm::max(p - b.low, b.high - p);
    return dot(far, far);
}

/// False if a coordinate is NaN, infinite or at least 1e30.
inline bool finite(const Box& b) {
    const Vec3 limit(1e30);
    return glm::all(glm::lessThan(glm::abs(b.low), limit)) &&
           glm::all(glm::lessThan(glm::abs(b.high), limit));
}

}  // namespace candelabra
