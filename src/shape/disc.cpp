// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/disc.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Disc::vocabulary = described<Disc>([] {
    using F = Field<Disc>;
    return schema<Disc>(
        "disc", {"A flat disc, with or without a hole.", "disc { y, <0, 1, -1>, 1, 0.4 }"},
        F{"centre", &Disc::centre, positional, "centre"},
        F{"normal", &Disc::normal, positional, "direction of its face, of any length but 0"},
        F{"radius", &Disc::radius, positional, "outer radius", any_sign()},
        maybe(F{"hole", &Disc::hole, positional, "radius of the hole", any_sign()}));
});

Box bounds(const Disc& disc) {
    const Vec3 n2 = unit(disc.normal) * unit(disc.normal);
    const Vec3 reach =
        disc.radius * glm::min(Vec3(1), glm::sqrt(Vec3(n2.y + n2.z, n2.z + n2.x, n2.x + n2.y)));
    return {disc.centre - reach, disc.centre + reach};
}

void crossings(const Disc& disc, const Ray& ray, Crossings& found) {
    const Vec3 normal = unit(disc.normal);
    const double approach = dot(ray.direction, normal);
    if (approach == 0) return;
    const Vec3 offset = ray.origin - disc.centre;
    const double t = -dot(offset, normal) / approach;
    const Vec3 hit = offset + t * ray.direction;
    const double distance2 = dot(hit, hit);
    if (distance2 <= disc.radius * disc.radius && distance2 >= disc.hole * disc.hole)
        found.add({t, normal, approach < 0});
}

bool inside(const Disc& disc, const Vec3& point) {
    return dot(unit(disc.normal), point - disc.centre) < 0;
}

Box inside_bounds(const Disc&) { return everywhere(); }

std::string problem(const Disc& disc) {
    const double size = length(disc.normal);
    return size > 0 && size < 1e150
               ? ""
               : "a `disc` needs a normal with a length above 0 and below 1e150";
}

std::string vanishes(const Disc& disc) {
    if (disc.radius == 0) return "its radius is 0";
    return disc.hole < disc.radius ? "" : "its hole is as wide as itself";
}

}  // namespace candelabra
