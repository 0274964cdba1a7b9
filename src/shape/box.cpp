// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/box.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Cuboid::vocabulary = described<Cuboid>([] {
    using F = Field<Cuboid>;
    return schema<Cuboid>(
        "box",
        {"A solid between two opposite corners, its faces along the axes.",
         "box { <-0.9, 0, -0.9>, <0.9, 1.6, 0.9> rotate 25*y }"},
        F{"corner1", &Cuboid::corner1, positional, "one corner"},
        F{"corner2", &Cuboid::corner2, positional, "the opposite corner, in any order"});
});

Box bounds(const Cuboid& cuboid) {
    return {glm::min(cuboid.corner1, cuboid.corner2), glm::max(cuboid.corner1, cuboid.corner2)};
}

void crossings(const Cuboid& cuboid, const Ray& ray, Crossings& found) {
    const Box box = bounds(cuboid);
    Interval within{-std::numeric_limits<double>::infinity()};
    int first = -1, last = -1;
    for (int axis = 0; axis < 3; ++axis) {
        const double step = ray.direction[axis], origin = ray.origin[axis];
        if (step == 0) {
            if (origin < box.low[axis] || origin > box.high[axis]) return;
            continue;
        }
        double near = (box.low[axis] - origin) / step, far = (box.high[axis] - origin) / step;
        if (step < 0) std::swap(near, far);
        if (near > within.min) within.min = near, first = axis;
        if (far < within.max) within.max = far, last = axis;
    }
    // A box without thickness is entered and left at the same t; a ray through an edge of any other
    // box only touches it.
    if (first < 0 || last < 0 || within.min > within.max ||
        (within.min == within.max && first != last))
        return;
    Vec3 entered(0), left(0);
    entered[first] = ray.direction[first] > 0 ? -1 : 1;
    left[last] = ray.direction[last] > 0 ? 1 : -1;
    found.add({within.min, entered, true});
    found.add({within.max, left, false});
}

bool inside(const Cuboid& cuboid, const Vec3& point) { return contains(bounds(cuboid), point); }

}  // namespace candelabra
