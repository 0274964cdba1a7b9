// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/sor.h"

#include "vocabulary/schema.h"

#include "shape/slab_interval.h"

#include "base/roots.h"

namespace candelabra {

const ItemInfo Sor::vocabulary = described<Sor>([] {
    using F = Field<Sor>;
    return schema<Sor>(
        "sor",
        {"A curve turned around the y axis, with one radius at each height.",
         "sor { 6, <0.8, -0.3>, <0.8, 0>, <0.5, 0.6>, <0.8, 1.2>, <0.5, 1.7>, <0.2, 2> open }"},
        F{"points", &Sor::points, counted,
          "<radius, y> with rising y; the first and the last only shape the curve"},
        F{"open", &Sor::open, flag, "leaves the ends out"});
});

namespace {

/// The slope of the squared radius at an inner point.
double slope_at(std::span<const Vec2> points, std::size_t i) {
    const Vec2 &before = points[i - 1], &after = points[i + 1];
    return 2 * points[i].x * (after.x - before.x) / (after.y - before.y);
}

/// Cubic Hermite interpolation between the points i and i + 1.
BuiltSor::Part part(std::span<const Vec2> points, std::size_t i) {
    const double h = points[i + 1].y - points[i].y;
    const double r0 = points[i].x * points[i].x, r1 = points[i + 1].x * points[i + 1].x;
    const double s0 = slope_at(points, i), s1 = slope_at(points, i + 1);
    const double mean = (r1 - r0) / h;
    const std::array<double, 4> factors = {r0, s0, (3 * mean - 2 * s0 - s1) / h,
                                           (s0 + s1 - 2 * mean) / (h * h)};
    double reach2 = std::fmax(r0, r1);
    const std::array<double, 3> slope = {factors[1], 2 * factors[2], 3 * factors[3]};
    for (const double turn : sign_changes(slope, {0, h}))
        reach2 = std::fmax(reach2, polynomial(factors, turn));
    return {points[i].y, points[i + 1].y, factors, r0, r1, reach2};
}

/// A ray of unit length that starts at its point nearest to the axis.
struct AxisRay {
    Ray ray;
    double start;  ///< of the original ray, in its parameter times its speed
    double nearest2, across2;

    /// Positive where the ray is within the squared radius.
    double depth(double radius2, double s) const { return radius2 - nearest2 - across2 * s * s; }
};

/// Coefficients of the depth by s along the ray, in one part.
std::array<double, 4> depth_along(const AxisRay& seen, const BuiltSor::Part& p) {
    const double h = seen.ray.origin.y - p.low, rise = seen.ray.direction.y;
    const auto& f = p.factors;
    return {polynomial(f, h) - seen.nearest2, rise * (f[1] + h * (2 * f[2] + 3 * h * f[3])),
            rise * rise * (f[2] + 3 * h * f[3]) - seen.across2, rise * rise * rise * f[3]};
}

/// A stretch of the ray, with the depths at its ends.
struct Stretch {
    Interval range;
    double at_min = -1, at_max = -1;
};

/// Maximum distance along the ray from its middle to a point within the largest radius.
double reach_along(const AxisRay& seen, double reach2) {
    const double limit2 = std::fmax(0, reach2 - seen.nearest2) / seen.across2;
    return seen.across2 > 1e-18 ? std::sqrt(limit2) * (1 + 1e-9) : 1e30;
}

/// The stretch between the heights of a part, limited by the largest radius.
Stretch stretch(const AxisRay& seen, const BuiltSor::Part& p, double limit) {
    Stretch result{{-limit, limit}};
    const double rise = seen.ray.direction.y, y = seen.ray.origin.y;
    if (rise == 0) return y >= p.low && y < p.high ? result : Stretch{{1, -1}};
    double first = (p.low - y) / rise, last = (p.high - y) / rise;
    double at_first = seen.depth(p.low2, first), at_last = seen.depth(p.high2, last);
    if (rise < 0) {
        std::swap(first, last);
        std::swap(at_first, at_last);
    }
    if (first > result.range.min) result.range.min = first, result.at_min = at_first;
    if (last < result.range.max) result.range.max = last, result.at_max = at_last;
    return result;
}

void cross_end(const AxisRay& seen, double y, double radius2, double side, const Ray& ray,
               Crossings& found) {
    const double rise = seen.ray.direction.y;
    if (rise == 0) return;
    const double s = (y - seen.ray.origin.y) / rise;
    if (seen.depth(radius2, s) < 0) return;
    const Vec3 outward(0, side, 0);
    const double t = (seen.start + s) / length(ray.direction);
    found.add({meeting_with_end(ray, Vec3(0, y, 0), outward, t), outward, rise * side < 0});
}

}  // namespace

BuiltSor build(const Sor& sor) {
    BuiltSor result;
    result.open = sor.open;
    double reach2 = 0;
    for (std::size_t i = 1; i + 2 < sor.points.size(); ++i) {
        const BuiltSor::Part p = part(sor.points, i);
        reach2 = std::fmax(reach2, p.reach2);
        result.parts.push_back(p);
    }
    const double reach = std::sqrt(reach2);
    result.bounds = {Vec3(-reach, result.parts.front().low, -reach),
                     Vec3(reach, result.parts.back().high, reach)};
    return result;
}

std::string problem(const Sor& sor) {
    if (sor.points.size() < 4) return "a `sor` needs at least 4 points";
    double widest = 0;
    for (std::size_t i = 0; i < sor.points.size(); ++i) {
        const Vec2& p = sor.points[i];
        if (p.x < 0) return "a `sor` needs radii that are not below 0";
        widest = std::fmax(widest, p.x);
        if (i == 0 || p.y > sor.points[i - 1].y) continue;
        const bool outer = i == 1 || i + 1 == sor.points.size();
        if (!outer) return "a `sor` needs heights that rise from point to point";
        // An outer point may have any height but that of the point two places away.
        const Vec2& other = i == 1 ? sor.points[2] : sor.points[i - 2];
        if ((i == 1 ? sor.points[0] : p).y == other.y)
            return "a `sor` needs heights that rise from point to point";
    }
    return widest > 0 ? "" : "a `sor` needs a radius above 0";
}

Box bounds(const BuiltSor& sor) { return sor.bounds; }

void crossings(const BuiltSor& sor, const Ray& ray, Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    const Vec3 d = ray.direction / speed;
    const double across2 = d.x * d.x + d.z * d.z;
    const double start = across2 > 1e-12 ? -(ray.origin.x * d.x + ray.origin.z * d.z) / across2
                                         : dot(sor.bounds.centre() - ray.origin, d);
    const Vec3 near = ray.origin + start * d;
    const AxisRay seen{{near, d}, start, near.x * near.x + near.z * near.z, across2};
    const double limit = reach_along(seen, sor.bounds.high.x * sor.bounds.high.x);
    for (const BuiltSor::Part& p : sor.parts) {
        if (seen.nearest2 > p.reach2 * (1 + 1e-9)) continue;
        const Stretch within = stretch(seen, p, limit);
        if (!(within.range.min < within.range.max)) continue;
        const Roots places =
            sign_changes(depth_along(seen, p), within.range, within.at_min, within.at_max);
        for (const double s : places) {
            const Vec3 q = seen.ray.at(s);
            const double h = q.y - p.low;
            const auto& f = p.factors;
            const double slope = f[1] + h * (2 * f[2] + 3 * h * f[3]);
            const Vec3 normal = unit(Vec3(q.x, -0.5 * slope, q.z));
            if (normal != Vec3(0)) found.add({(start + s) / speed, normal, dot(d, normal) < 0});
        }
    }
    if (sor.open) return;
    const BuiltSor::Part &lowest = sor.parts.front(), &highest = sor.parts.back();
    cross_end(seen, lowest.low, lowest.low2, -1, ray, found);
    cross_end(seen, highest.high, highest.high2, 1, ray, found);
}

bool inside(const BuiltSor& sor, const Vec3& point) {
    const double radius2 = point.x * point.x + point.z * point.z;
    for (const BuiltSor::Part& p : sor.parts)
        if (point.y >= p.low && point.y <= p.high)
            return radius2 <= polynomial(p.factors, point.y - p.low);
    return false;
}

}  // namespace candelabra
