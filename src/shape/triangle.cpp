// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/triangle.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Triangle::vocabulary = described<Triangle>([] {
    using F = Field<Triangle>;
    return schema<Triangle>(
        "triangle",
        {"A flat triangle.", "triangle { <-1.2, 0.2, 0>, <1.2, 0.2, 0>, <0, 1.8, 0.3> }"},
        F{"corner1", &Triangle::corner1, positional, "first corner"},
        F{"corner2", &Triangle::corner2, positional, "second corner"},
        F{"corner3", &Triangle::corner3, positional, "third corner"});
});

const ItemInfo SmoothTriangle::vocabulary = described<SmoothTriangle>([] {
    using F = Field<SmoothTriangle>;
    return schema<SmoothTriangle>(
        "smooth_triangle",
        {"A flat triangle that is shaded as if it were curved.",
         "smooth_triangle { <-1.2, 0.2, 0>, <-1, 0, -1>, <1.2, 0.2, 0>, <1, 0, -1>, <0, 1.8, 0>, "
         "<0, 1, -1> }"},
        F{"corner1", &SmoothTriangle::corner1, positional, "first corner"},
        F{"normal1", &SmoothTriangle::normal1, positional, "surface normal there"},
        F{"corner2", &SmoothTriangle::corner2, positional, "second corner"},
        F{"normal2", &SmoothTriangle::normal2, positional, "surface normal there"},
        F{"corner3", &SmoothTriangle::corner3, positional, "third corner"},
        F{"normal3", &SmoothTriangle::normal3, positional, "surface normal there"});
});

namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();

/// A convex polygon: a triangle clipped by at most six planes, each of which adds at most one
/// corner.
struct ClippedPolygon {
    std::array<Vec3, 9> corners;
    std::size_t count = 0;

    void add(const Vec3& corner) { corners[count++] = corner; }
};

/// Clips to one side of a plane across an axis (Sutherland and Hodgman): above it for sign 1, below
/// it for sign -1.
void cut(const ClippedPolygon& polygon, int axis, double plane, double sign,
         ClippedPolygon& result) {
    result.count = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Vec3 &from = polygon.corners[i],
                   &to = polygon.corners[i + 1 < polygon.count ? i + 1 : 0];
        const double before = sign * (from[axis] - plane), after = sign * (to[axis] - plane);
        if (before >= 0) result.add(from);
        if ((before > 0 && after < 0) || (before < 0 && after > 0)) {
            Vec3 between = from + before / (before - after) * (to - from);
            between[axis] = plane;
            result.add(between);
        }
    }
}

Box corner_box(const Vec3& a, const Vec3& b, const Vec3& c) { return join(join(Box{a, a}, b), c); }

Box corner_box(const ClippedPolygon& polygon) {
    Box box;
    for (std::size_t i = 0; i < polygon.count; ++i) box = join(box, polygon.corners[i]);
    return box;
}

double extent(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::fmax(max_abs_component(a), std::fmax(max_abs_component(b), max_abs_component(c)));
}

/// Whether the points are collinear within the precision of their coordinates.
bool on_one_line(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest = std::fmax(length(a - b), std::fmax(length(b - c), length(c - a)));
    return !(length(cross(a - b, c - b)) > 4 * ulp * extent(a, b, c) * longest);
}

}  // namespace

int ShearedRay::exact_side(const Vec2& p, const Vec2& q) {
    const auto sign = [](double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
    const double left = q.x * p.y, right = q.y * p.x;
    if (left != right) return sign(left - right);
    const double lost = std::fma(q.x, p.y, -left) - std::fma(q.y, p.x, -right);
    if (lost != 0) return sign(lost);
    return q.y != p.y ? sign(q.y - p.y) : sign(p.x - q.x);
}

TriangleHit first_crossing(const Vec3& corner1, const Vec3& corner2, const Vec3& corner3,
                           const Ray& ray, const Interval& range) {
    return ShearedRay(ray).meet(corner1, corner2, corner3, range);
}

Box bounds(const Triangle& t) { return corner_box(t.corner1, t.corner2, t.corner3); }

void crossings(const Triangle& t, const Ray& ray, Crossings& found) {
    const TriangleHit hit = first_crossing(t.corner1, t.corner2, t.corner3, ray, whole_line);
    if (!(hit.t < whole_line.max)) return;
    const Vec3 normal = triangle_normal(t.corner1, t.corner2, t.corner3);
    found.add({hit.t, normal, dot(ray.direction, normal) < 0});
}

bool inside(const Triangle&, const Vec3&) { return false; }

Box clipped_bounds(const Triangle& t, const Box& cell) {
    if (cell.empty()) return {};
    Box part = bounds(t);
    const Vec3 pad(32 * ulp * max_component(glm::max(-part.low, part.high)));
    const Box around{cell.low - pad, cell.high + pad};
    ClippedPolygon polygon, rest;
    polygon.add(t.corner1);
    polygon.add(t.corner2);
    polygon.add(t.corner3);
    ClippedPolygon *now = &polygon, *next = &rest;
    const auto keep = [&](int axis, double plane, double sign) {
        cut(*now, axis, plane, sign, *next);
        std::swap(now, next);
    };
    // Most planes of a cell do not cut the triangle.
    for (int axis = 0; axis < 3; ++axis) {
        const bool low = part.low[axis]<around.low[axis], high = part.high[axis]> around.high[axis];
        if (low) keep(axis, around.low[axis], 1);
        if (high) keep(axis, around.high[axis], -1);
        if (now->count == 0) return {};
        if (low || high) part = corner_box(*now);
    }
    return clip(Box{part.low - pad, part.high + pad}, cell);
}

std::string vanishes(const Triangle& t) {
    return on_one_line(t.corner1, t.corner2, t.corner3) ? "its corners are on one line" : "";
}

Box bounds(const SmoothTriangle& t) { return corner_box(t.corner1, t.corner2, t.corner3); }

void crossings(const SmoothTriangle& t, const Ray& ray, Crossings& found) {
    const TriangleHit hit = first_crossing(t.corner1, t.corner2, t.corner3, ray, whole_line);
    if (!(hit.t < whole_line.max)) return;
    Vec3 normal = unit((1 - hit.weight2 - hit.weight3) * unit(t.normal1) +
                       hit.weight2 * unit(t.normal2) + hit.weight3 * unit(t.normal3));
    if (normal == Vec3(0)) normal = triangle_normal(t.corner1, t.corner2, t.corner3);
    found.add({hit.t, normal, dot(ray.direction, normal) < 0});
}

bool inside(const SmoothTriangle&, const Vec3&) { return false; }

std::string problem(const SmoothTriangle& t) {
    if (!vanishes(t).empty()) return {};
    for (const Vec3& normal : {t.normal1, t.normal2, t.normal3})
        if (!(length(normal) < 1e150))
            return "a `smooth_triangle` needs normals with lengths below 1e150";
    return {};
}

std::string vanishes(const SmoothTriangle& t) {
    if (const std::string why = vanishes(Triangle{t.corner1, t.corner2, t.corner3}); !why.empty())
        return why;
    const Vec3 face = cross(t.corner2 - t.corner1, t.corner3 - t.corner1);
    const Vec3 sides{dot(face, t.normal1), dot(face, t.normal2), dot(face, t.normal3)};
    const bool all =
        glm::all(glm::greaterThan(sides, Vec3(0))) || glm::all(glm::lessThan(sides, Vec3(0)));
    return all ? "" : "its normals are not all on one side of it";
}

Vec3 corner_weights(const std::array<Vec3, 3>& corners, const Vec3& point) {
    const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = dot(normal, normal);
    if (size == 0) return Vec3(1, 0, 0);
    const double second = dot(cross(point - corners[0], corners[2] - corners[0]), normal) / size;
    const double third = dot(cross(corners[1] - corners[0], point - corners[0]), normal) / size;
    return {1 - second - third, second, third};
}

}  // namespace candelabra
