// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/cylinder.h"

#include "vocabulary/schema.h"

#include "shape/cone.h"

const ItemInfo Cylinder::vocabulary = described<Cylinder>([] {
    using F = Field<Cylinder>;
    return schema<Cylinder>("cylinder", "A cylinder with flat ends.",
                            F{"base", &Cylinder::base, positional, "centre of one end"},
                            F{"cap", &Cylinder::cap, positional, "centre of the other end"},
                            F{"radius", &Cylinder::radius, positional, "radius", any_sign()},
                            F{"open", &Cylinder::open, flag, "leaves the ends out"});
});

namespace {

/// A cylinder is the cone whose radius stays the same.
Cone as_cone(const Cylinder& c) { return {c.base, c.radius, c.cap, c.radius, c.open}; }

}  // namespace

Box bounds(const Cylinder& cylinder) { return bounds(as_cone(cylinder)); }

void crossings(const Cylinder& cylinder, const Ray& ray, Crossings& found) {
    crossings(as_cone(cylinder), ray, found);
}

bool inside(const Cylinder& cylinder, const Vec3& point) {
    return inside(as_cone(cylinder), point);
}

std::string problem(const Cylinder& cylinder) {
    return length(cylinder.cap - cylinder.base) > 0 ? ""
                                                    : "a `cylinder` needs two different end points";
}

std::string vanishes(const Cylinder& cylinder) {
    return cylinder.radius == 0 ? "its radius is 0" : "";
}
