// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/segment_bound.h"

#include "shape/slab_interval.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace candelabra {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();

/// A segment with a disc of the given radius around each of its points.
Stick round(const Vec3& from, const Vec3& to, double radius) {
    const Vec3 u = unit(to - from), u2 = u * u;
    return {from, to, std::abs(radius) * glm::sqrt(Vec3(u2.y + u2.z, u2.z + u2.x, u2.x + u2.y))};
}

/// The image of the segment and of the reach around it.
Stick transformed(const Stick& stick, const Transform& map) {
    Vec3 reach(0);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 side(0);
        side[axis] = stick.reach[axis];
        reach += glm::abs(map.direction(side));
    }
    return {map.point(stick.from), map.point(stick.to), reach};
}

/// The box as a segment along one of its sides.
Stick along(const Box& box, int axis) {
    Stick stick{box.centre(), box.centre(), 0.5 * box.size()};
    stick.from[axis] = box.low[axis];
    stick.to[axis] = box.high[axis];
    stick.reach[axis] = 0;
    return stick;
}

}  // namespace

Stick stick_around(const BuiltShape& shape, const Box& box, const Transform* map) {
    const auto placed = [&](const Stick& stick) { return map ? transformed(stick, *map) : stick; };
    if (const auto* c = std::get_if<Cylinder>(&shape))
        return placed(round(c->base, c->cap, c->radius));
    if (const auto* c = std::get_if<Cone>(&shape))
        return placed(round(c->base, c->cap, std::max(c->base_radius, c->cap_radius)));
    std::array<Stick, 3> sticks;
    for (int axis = 0; axis < 3; ++axis)
        sticks[static_cast<std::size_t>(axis)] = placed(along(box, axis));
    return *std::ranges::max_element(
        sticks, {}, [](const Stick& stick) { return length(stick.to - stick.from); });
}

Box clipped_bounds(const Stick& stick, const Box& cell) {
    const Vec3 way = stick.to - stick.from;
    Interval within{0, 1};
    for (int axis = 0; axis < 3; ++axis) {
        const double start = stick.from[axis];
        const double pad = 8 * rounding * (std::abs(start) + std::abs(way[axis]));
        const double more = stick.reach[axis] + pad;
        const Interval part =
            between_ends(start - cell.low[axis] + more, cell.high[axis] - start + more, way[axis]);
        within = {std::max(within.min, part.min), std::min(within.max, part.max)};
    }
    if (!(within.min <= within.max)) return {};
    const Vec3 from = stick.from + within.min * way, to = stick.from + within.max * way;
    const Vec3 more = stick.reach + 8 * rounding * (glm::abs(from) + glm::abs(way));
    return clip(Box{glm::min(from, to) - more, glm::max(from, to) + more}, cell);
}

}  // namespace candelabra
