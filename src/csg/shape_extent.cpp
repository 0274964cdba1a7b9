// SPDX-License-Identifier: GPL-3.0-or-later
#include "csg/shape_extent.h"

#include "base/elementary.h"
#include "base/long_work.h"
#include "shape/built_shape.h"

#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

using Place = const Transform*;

Box widened(const Box& box, const Vec3& by) { return {box.low - by, box.high + by}; }
Box placed(const Box& box, Place place) { return place ? place->box(box) : box; }
Vec3 placed(const Vec3& point, Place place) { return place ? place->point(point) : point; }
Vec3 turned(const Vec3& direction, Place place) {
    return place ? place->direction(direction) : direction;
}

/// The box around the untransformed shape.
template <class T>
Box extent_of(const T& shape) {
    return bounds(ready(shape));
}

/// A box alone needs no index of the faces.
Box extent_of(const Mesh& mesh) {
    Box box;
    count_long_work(mesh.faces.size());
    for (const Face& face : mesh.faces)
        for (const int corner : face)
            box = join(box, mesh.vertices[static_cast<std::size_t>(corner)]);
    return box;
}
Box extent_of(const TriangleMesh& mesh) { return extent_of(as_mesh(mesh)); }
Box extent_of(const Superellipsoid& s) { return widened(bounds(s), Vec3(0.0001)); }

/// Only axis-aligned ellipsoids are bounded.
Box extent_of(const Quadric& quadric) {
    const Vec3& s = quadric.squares;
    const bool same = (s.x > 0 && s.y > 0 && s.z > 0) || (s.x < 0 && s.y < 0 && s.z < 0);
    Box box{Vec3(-std::numeric_limits<double>::infinity()),
            Vec3(std::numeric_limits<double>::infinity())};
    if (!same || quadric.products != Vec3(0)) return box;
    const Vec3 centre = -0.5 * quadric.linear / s;
    const double rest = dot(s * centre, centre) - quadric.constant;
    const Vec3 half2 = rest / s;
    if (!(half2.x >= 0)) return box;
    return {centre - glm::sqrt(half2), centre + glm::sqrt(half2)};
}

/// The arc between the two spheres is widest here, even if that place is not part of the shape.
Box extent_of(const Ovus& ovus) {
    const double bottom = ovus.bottom_radius, top = ovus.top_radius;
    Box box = bounds(ovus);
    if (!(top < 2 * bottom)) return box;
    const double arc = 2 * std::fmax(bottom, top), to_bottom = arc - bottom, to_top = arc - top;
    const double y = (to_bottom * to_bottom - to_top * to_top + bottom * bottom) / (2 * bottom);
    const double wide = arc - std::sqrt(std::fmax(0, to_bottom * to_bottom - y * y));
    box.low.x = box.low.z = -wide;
    box.high.x = box.high.z = wide;
    return box;
}

/// Bounds of all control points of the curves.
Box extent_of(const Lathe& lathe) {
    Box box = bounds(ready(lathe));
    if (lathe.spline != bezier_curve) return box;
    for (const Vec2& p : lathe.points) {
        box = join(box, Vec3(p.x, p.y, p.x));
        box = join(box, Vec3(-p.x, p.y, -p.x));
    }
    return box;
}

Box extent_of(const Prism& prism) {
    Box box = bounds(ready(prism));
    if (prism.spline != bezier_curve) return box;
    for (const Vec2& p : prism.points)
        for (const double y : {box.low.y, box.high.y}) {
            const Vec2 q = prism.sweep == linear_sweep ? p : y * p;
            box = join(box, Vec3(q.x, y, q.y));
        }
    return box;
}

Box extent_of(const SphereSweep& sweep) {
    if (sweep.spline == linear_way) return bounds(ready(sweep));
    Box box;
    for (const Ball& ball : sweep.spheres) {
        const Vec3 half((sweep.spline == cubic_way ? 2 : 1) * std::abs(ball.radius));
        box = join(box, Box{ball.centre - half, ball.centre + half});
    }
    return box;
}

/// The x and y axes after the shortest rotation from z to an axis.
struct Frame {
    explicit Frame(const Vec3& axis) {
        const Vec3 across = cross(Vec3(0, 0, 1), axis);
        if (across == Vec3(0)) return;
        const double angle = math::acos(std::fmax(-1, std::fmin(1, axis.z)));
        const Transform turn = Transform::rotation(across, angle * 180 / std::numbers::pi);
        x = turn.direction(x);
        y = turn.direction(y);
    }
    Vec3 x = Vec3(1, 0, 0), y = Vec3(0, 1, 0);
};

/// Half extents of a transformed square from -1 to 1 across the axis.
Vec3 square_across(const Vec3& axis, Place place) {
    const Frame frame(axis);
    return glm::abs(turned(frame.x, place)) + glm::abs(turned(frame.y, place));
}

/// Box of a square rod from the end with the smaller radius.
Box rod(const Vec3& from, const Vec3& to, double radius, Place place) {
    const Vec3 half = radius * square_across(unit(to - from), place);
    const Vec3 a = placed(from, place), b = placed(to, place);
    return widened(join(Box{a, a}, b), half);
}

template <class T>
Box placed_extent(const T& shape, Place place) {
    return placed(extent_of(shape), place);
}

/// A sphere stays one when it is rotated and scaled uniformly.
/// (In POV-Ray, not under `transform { }` and `matrix`.)
Box placed_extent(const Sphere& s, Place place) {
    if (!place) return extent_of(s);
    const Vec3 x = turned(Vec3(1, 0, 0), place), y = turned(Vec3(0, 1, 0), place),
               z = turned(Vec3(0, 0, 1), place);
    const double growth2 = dot(x, x), most = 1e-9 * growth2;
    const bool alike = std::abs(dot(y, y) - growth2) < most &&
                       std::abs(dot(z, z) - growth2) < most && std::abs(dot(x, y)) < most &&
                       std::abs(dot(y, z)) < most && std::abs(dot(z, x)) < most;
    if (!alike) return placed(extent_of(s), place);
    const Vec3 centre = placed(s.centre, place);
    return widened({centre, centre}, Vec3(std::sqrt(growth2) * std::abs(s.radius)));
}

Box placed_extent(const Cylinder& c, Place place) { return rod(c.cap, c.base, c.radius, place); }

Box placed_extent(const Cone& c, Place place) {
    return c.cap_radius > c.base_radius ? rod(c.base, c.cap, c.cap_radius, place)
                                        : rod(c.cap, c.base, c.base_radius, place);
}

Box placed_extent(const Disc& disc, Place place) {
    const Vec3 axis = unit(disc.normal), centre = placed(disc.centre, place);
    return widened({centre, centre}, std::abs(disc.radius) * square_across(axis, place) +
                                         0.001 * glm::abs(turned(axis, place)));
}

template <class Points>
Box around(const Points& points, Place place) {
    Box box;
    for (const Vec3& point : points) box = join(box, placed(point, place));
    return box;
}

Box placed_extent(const Triangle& t, Place place) {
    return around(std::array{t.corner1, t.corner2, t.corner3}, place);
}
Box placed_extent(const SmoothTriangle& t, Place place) {
    return around(std::array{t.corner1, t.corner2, t.corner3}, place);
}
Box placed_extent(const BicubicPatch& patch, Place place) { return around(patch.points, place); }
Box placed_extent(const Polygon& polygon, Place place) {
    constexpr double thin = 0.001;
    const Box box = around(polygon.points, place);
    return widened(box, thin * Vec3(glm::lessThan(box.size(), Vec3(thin))));
}

/// Box of a ball whose radius is scaled by the largest growth of a cube's half extents.
Box around_ball(const Vec3& centre, double radius, const Vec3& growth, Place place) {
    const Vec3 at = placed(centre, place);
    const Vec3 half(radius * std::fmax(growth.x, std::fmax(growth.y, growth.z)));
    return {at - half, at + half};
}
Vec3 cube(const Vec3& axis, Place place) {
    return square_across(axis, place) + glm::abs(turned(axis, place));
}

Box placed_extent(const Blob& blob, Place place) {
    Box box;
    for (const BlobSphere& s : blob.spheres)
        if (s.strength > 0)
            box = join(box, around_ball(s.centre, s.radius, cube(Vec3(0, 0, 1), &s.transform),
                                        &s.transform));
    for (const BlobComponent& c : blob.components)
        if (c.strength > 0) box = join(box, around_ball(c.centre, c.radius, Vec3(1), nullptr));
    for (const BlobCylinder& c : blob.cylinders) {
        if (!(c.strength > 0)) continue;
        const double length = candelabra::length(c.cap - c.base);
        const Vec3 growth = cube((c.cap - c.base) / length, &c.transform);
        const Vec3 middle = 0.5 * (c.base + c.cap);
        const double reach = std::sqrt(0.25 * length * length + c.radius * c.radius);
        box = join(box, around_ball(middle, reach, growth, &c.transform));
        for (const Vec3& end : {c.base, c.cap})
            box = join(box, around_ball(end, c.radius, growth, &c.transform));
    }
    return placed(box.empty() ? extent_of(blob) : box, place);
}

}  // namespace

Box shape_extent(const Shape& shape, const Transform* place) {
    return visit_shape([&](const auto& content) { return placed_extent(content, place); }, shape);
}

}  // namespace candelabra
