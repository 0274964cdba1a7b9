// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/torus.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include "base/roots.h"
#include "shape/sphere.h"

namespace candelabra {

const ItemInfo Torus::vocabulary = described<Torus>([] {
    using F = Field<Torus>;
    return schema<Torus>(
        "torus",
        {"A ring around the y axis.", "torus { 1, 0.4 rotate -30*x translate 0.9*y }",
         "torus { 0.5, 0.7 merge translate 0.7*y }",
         "difference { torus { 0.5, 0.7 union } plane { z, 0 } translate 0.7*y }",
         "difference { torus { 0.5, 0.7 difference } plane { z, 0 } translate 0.7*y }",
         "torus { 0.5, 0.9 intersection translate 0.7*y }"},
        F{"major", &Torus::major, positional, "radius of the ring's centre line", at_least(0)},
        F{"minor", &Torus::minor, positional, "radius of the tube", at_least(0)},
        F{"union", &Torus::whole, flag, "a tube wider than the ring: all of its surface"},
        F{"merge", &Torus::merged, flag, "of a tube wider than the ring, the outer surface only"},
        F{"difference", &Torus::hollow, flag,
          "of a tube wider than the ring, the part that is covered once"},
        F{"intersection", &Torus::spindle, flag,
          "of a tube wider than the ring, the part that is covered twice"});
});

namespace {

double from_axis(const Vec3& p) { return math::hypot(p.x, p.z); }

/// Whether a point of the surface is on the spindle: the inner sheet of a torus that intersects
/// itself, whose tube lies on the other side of the axis.
bool on_spindle(const Torus& torus, const Vec3& p) {
    const double ring = from_axis(p);
    const double minor2 = torus.minor * torus.minor;
    const double outer = (ring - torus.major) * (ring - torus.major) + p.y * p.y - minor2;
    const double inner = (ring + torus.major) * (ring + torus.major) + p.y * p.y - minor2;
    return std::abs(inner) < std::abs(outer);
}

/// Unit normal away from the middle of the tube.
Vec3 normal_at(const Torus& torus, const Vec3& p, bool spindle) {
    const double ring = from_axis(p);
    const double to_tube = spindle ? -torus.major : torus.major;
    const double scale = ring > 0 ? 1 - to_tube / ring : 1;
    return unit(Vec3(p.x * scale, p.y, p.z * scale));
}

/// Whether a sheet of the surface is there.
bool is_shown(const Torus& torus, bool spindle) {
    if (torus.spindle) return spindle;
    return !(spindle && torus.merged && !torus.hollow);
}

/// The part of the range where the ray is between the planes tangent to the tube from above and
/// below, slightly enlarged.
Interval between_planes(double minor, const Ray& ray, Interval range) {
    const double height = minor * (1 + 1e-9), y = ray.origin.y, rise = ray.direction.y;
    if (rise == 0) return std::abs(y) > height ? Interval{1, 0} : range;
    const double above = (height - y) / rise, below = (-height - y) / rise;
    return {std::fmax(range.min, std::fmin(above, below)),
            std::fmin(range.max, std::fmax(above, below))};
}

}  // namespace

Box bounds(const Torus& torus) {
    const Vec3 reach(torus.major + torus.minor, torus.minor, torus.major + torus.minor);
    return {-reach, reach};
}

void crossings(const Torus& torus, const Ray& ray, Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    // A sphere covered twice has only double roots.
    if (torus.major == 0 && !(torus.hollow && !torus.spindle))
        return crossings(Sphere{Vec3(0), torus.minor}, ray, found);
    if (torus.major == 0) return;
    // Starting from the point nearest to the centre, the quartic has no cubic term, and distant
    // origins lose no digits.
    const Vec3 u = ray.direction / speed;
    double start = -dot(ray.origin, u);
    Vec3 near = ray.origin + start * u;
    const double rest = dot(near, u);
    near -= rest * u;
    start -= rest;
    const double reach = torus.major + torus.minor, near2 = dot(near, near);
    if (!(near2 < reach * reach)) return;
    const double half = std::sqrt(reach * reach - near2) * (1 + 1e-9);
    const Interval range = between_planes(torus.minor, {near, u}, {-half, half});
    if (!(range.min < range.max)) return;

    const double R = torus.major, ring = from_axis(near);
    const double k = near2 + (R - torus.minor) * (R + torus.minor);
    const std::array<double, 5> quartic = {(k - 2 * R * ring) * (k + 2 * R * ring),
                                           -8 * R * R * (near.x * u.x + near.z * u.z),
                                           2 * k - 4 * R * R * (u.x * u.x + u.z * u.z), 0, 1};
    for (const double s : sign_changes(quartic, range)) {
        const Vec3 place = near + s * u;
        const bool spindle = on_spindle(torus, place);
        if (!is_shown(torus, spindle)) continue;
        const bool turned = spindle && torus.hollow && !torus.spindle;
        const Vec3 normal = (turned ? -1.0 : 1.0) * normal_at(torus, place, spindle);
        found.add({(start + s) / speed, normal, dot(u, normal) < 0});
    }
}

bool inside(const Torus& torus, const Vec3& point) {
    const auto within = [&](double off) {
        return off * off + point.y * point.y <= torus.minor * torus.minor;
    };
    const double ring = from_axis(point);
    if (torus.spindle) return within(ring + torus.major);
    return within(ring - torus.major) && !(torus.hollow && within(ring + torus.major));
}

std::string vanishes(const Torus& torus) {
    if (torus.minor == 0) return "the radius of its tube is 0";
    return torus.spindle && torus.minor <= torus.major ? "its tube covers nothing twice" : "";
}

}  // namespace candelabra
