// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/precedence.h"

#include "shape/slabs.h"

Box item_bounds(const World& world, std::uint32_t item) {
    if (item >= world.geometry.leaves_begin())
        return world.geometry.composites[item - world.geometry.leaves_begin()].composite->bounds();
    if (item < world.geometry.spheres.size()) {
        const SpherePrimitive& s = world.geometry.spheres[item];
        return {s.centre - s.radius, s.centre + s.radius};
    }
    const std::size_t face = item - world.geometry.spheres.size();
    if (face < world.geometry.triangles.size()) {
        const TrianglePrimitive& t = world.geometry.triangles[face];
        return join(join(Box{t.corner1, t.corner1}, t.corner2), t.corner3);
    }
    return world.geometry.shapes[face - world.geometry.triangles.size()].box;
}

bool precedes(const World& world, std::uint32_t item, std::uint32_t other, const Ray& ray) {
    constexpr double together = 1e-6;  // of a distance: more than boxes are too large
    const Slabs slabs(ray);
    const auto entry = [&](std::uint32_t i) {
        return slabs.within(item_bounds(world, i), {0, std::numeric_limits<double>::infinity()})
            .min;
    };
    const double here = entry(item), there = entry(other);
    if (std::abs(here - there) > together * std::max(std::abs(here), std::abs(there)))
        return here < there;
    return item < other;
}
