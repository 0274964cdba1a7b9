// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/area.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "base/random.h"
#include "shape/mesh_area.h"

#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Chooses one of the parts in proportion to its area, and rescales x over that part so that it can
/// be used again.
template <std::size_t N>
std::size_t choose_part(const std::array<double, N>& areas, double& x) {
    double total = 0;
    for (const double area : areas) total += area;
    double rest = x * total;
    std::size_t last = 0;
    for (std::size_t i = 0; i < N; ++i) {
        if (areas[i] <= 0) continue;
        last = i;
        if (rest < areas[i]) break;
        rest -= areas[i];
    }
    x = std::fmin(rest / areas[last], below_1);
    return last;
}

/// Direction perpendicular to the unit vector `up`, at the fraction u of a full turn.
Vec3 around(const Vec3& up, double u) {
    const auto [first, second] = perpendiculars(up);
    return on_circle(2 * pi * u, first, second);
}

/// Point of a ring around `up`, uniform by area, relative to the ring's centre.
Vec3 on_ring(const Vec3& up, double hole, double radius, const Vec2& u) {
    return std::sqrt(hole * hole + u.x * (radius * radius - hole * hole)) * around(up, u.y);
}

/// Areas of the side, the base and the cap.
std::array<double, 3> part_areas(const Cone& c) {
    const double slant = math::hypot(length(c.cap - c.base), c.cap_radius - c.base_radius);
    const double ends = c.open ? 0 : pi;
    return {pi * (c.base_radius + c.cap_radius) * slant, ends * c.base_radius * c.base_radius,
            ends * c.cap_radius * c.cap_radius};
}

/// The area up to a height grows with the square of the distance from the apex, and so of the
/// radius. The solution for the height also holds for equal radii, where there is no apex.
SurfacePoint on_side(const Cone& c, const Vec2& u) {
    const double r0 = c.base_radius, r1 = c.cap_radius;
    const double radius = std::sqrt(r0 * r0 + u.x * (r1 * r1 - r0 * r0));
    const double fraction = u.x * (r0 + r1) / (r0 + radius > 0 ? r0 + radius : 1);
    const Vec3 span = c.cap - c.base;
    const double height = length(span);
    const Vec3 up = span / height, out = around(up, u.y);
    return {c.base + fraction * span + radius * out, unit(out - (r1 - r0) / height * up)};
}

Cone as_cone(const Cylinder& c) { return {c.base, c.radius, c.cap, c.radius, c.open}; }

std::array<double, 3> face_areas(const Vec3& size) {
    return {size.y * size.z, size.z * size.x, size.x * size.y};
}

double area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 0.5 * length(cross(a - b, c - b));
}

SurfacePoint on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec2& u) {
    const double s = std::sqrt(u.x);
    return {(1 - s) * a + s * (1 - u.y) * b + s * u.y * c, triangle_normal(a, b, c)};
}

}  // namespace

double surface_area(const Sphere& s) { return 4 * pi * s.radius * s.radius; }

SurfacePoint sample_area(const Sphere& s, const Vec2& u) {
    const double z = 1 - 2 * u.x, across = 2 * std::sqrt(u.x * (1 - u.x));
    const Vec3 normal(across * on_circle(2 * pi * u.y), z);
    return {s.centre + s.radius * normal, normal};
}

double surface_area(const Cuboid& c) { return area(bounds(c)); }

SurfacePoint sample_area(const Cuboid& c, const Vec2& u) {
    const Box box = bounds(c);
    Vec2 left = u;
    const std::array<double, 3> areas = face_areas(box.size());
    const std::size_t face =
        choose_part(std::array{areas[0], areas[0], areas[1], areas[1], areas[2], areas[2]}, left.x);
    const int axis = static_cast<int>(face / 2), j = (axis + 1) % 3, k = (axis + 2) % 3;
    const bool high = face % 2 == 1;
    SurfacePoint result;
    result.position[axis] = high ? box.high[axis] : box.low[axis];
    result.position[j] = glm::mix(box.low[j], box.high[j], left.x);
    result.position[k] = glm::mix(box.low[k], box.high[k], left.y);
    result.normal[axis] = high ? 1 : -1;
    return result;
}

double surface_area(const Disc& d) {
    return pi * std::fmax(0, (d.radius - d.hole) * (d.radius + d.hole));
}

SurfacePoint sample_area(const Disc& d, const Vec2& u) {
    const Vec3 up = unit(d.normal);
    return {d.centre + on_ring(up, d.hole, d.radius, u), up};
}

double surface_area(const Cylinder& c) { return surface_area(as_cone(c)); }

SurfacePoint sample_area(const Cylinder& c, const Vec2& u) { return sample_area(as_cone(c), u); }

double surface_area(const Cone& c) {
    const auto [side, base, cap] = part_areas(c);
    return side + base + cap;
}

SurfacePoint sample_area(const Cone& c, const Vec2& u) {
    Vec2 left = u;
    const std::size_t part = choose_part(part_areas(c), left.x);
    if (part == 0) return on_side(c, left);
    const Vec3 up = unit(c.cap - c.base);
    if (part == 1) return {c.base + on_ring(up, 0, c.base_radius, left), -up};
    return {c.cap + on_ring(up, 0, c.cap_radius, left), up};
}

double surface_area(const Triangle& t) { return area(t.corner1, t.corner2, t.corner3); }

SurfacePoint sample_area(const Triangle& t, const Vec2& u) {
    return on_triangle(t.corner1, t.corner2, t.corner3, u);
}

double surface_area(const SmoothTriangle& t) { return area(t.corner1, t.corner2, t.corner3); }

SurfacePoint sample_area(const SmoothTriangle& t, const Vec2& u) {
    return on_triangle(t.corner1, t.corner2, t.corner3, u);
}

double surface_area(const BuiltMesh& m) { return m.area->total(); }

SurfacePoint sample_area(const BuiltMesh& m, const Vec2& u) {
    const auto [number, within] = m.area->at(u.x);
    const auto [a, b, c] = face(*m.mesh, number).corners;
    return on_triangle(a, b, c, {within, u.y});
}

}  // namespace candelabra
