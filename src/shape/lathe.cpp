// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/lathe.h"

#include "base/elementary.h"
#include "base/long_work.h"
#include "vocabulary/schema.h"

#include "shape/slab_interval.h"

namespace candelabra {

const ItemInfo Lathe::vocabulary = described<Lathe>([] {
    using F = Field<Lathe>;
    return schema<Lathe>(
        "lathe",
        {"A curve turned around the y axis.",
         "lathe { cubic_spline 7, <0, 0.1>, <0.8, 0>, <0.9, 0.5>, <0.4, 1>, <0.5, 1.5>, <0.8, "
         "1.8>, <0.9, 2> }",
         "lathe { linear_spline 4, <0.9, 0>, <0.9, 0.2>, <0.3, 0.4>, <0.8, 1.8> }",
         "lathe { quadratic_spline 5, <0, 0>, <0.9, 0>, <0.9, 0.5>, <0.3, 1>, <0.8, 1.8> }",
         "lathe { bezier_spline 4, <0.9, 0>, <0.9, 0.8>, <0.2, 1>, <0.8, 1.8> }"},
        F{"points", &Lathe::points, counted, "<radius, y> along the curve"},
        chooses("linear_spline", &Lathe::spline, linear_curve, "straight between the points"),
        chooses("quadratic_spline", &Lathe::spline, quadratic_curve,
                "smooth; the first point only shapes the curve"),
        chooses("cubic_spline", &Lathe::spline, cubic_curve,
                "smooth; the first and the last point only shape the curve"),
        chooses("bezier_spline", &Lathe::spline, bezier_curve,
                "each four points are a Bezier curve"));
});

namespace {

/// A ray of unit length that starts at its point nearest to the axis: its squared distance from the
/// axis is nearest2 + across2 s^2.
struct LatheRay {
    double nearest2, across2;
    double height, rise;

    LatheRay(const Vec3& origin, const Vec3& direction)
        : nearest2(origin.x * origin.x + origin.z * origin.z),
          across2(direction.x * direction.x + direction.z * direction.z),
          height(origin.y),
          rise(direction.y) {}

    /// Whether the ray may hit a part: its distance from the axis at the part's heights is in
    /// range.
    bool comes_near(const BuiltLathe::Part& part) const {
        Interval way = whole_line;
        if (rise != 0) {
            way = {(part.heights.min - height) / rise, (part.heights.max - height) / rise};
            if (rise < 0) std::swap(way.min, way.max);
        } else if (!part.heights.contains(height)) {
            return false;
        }
        const double farthest = std::fmax(-way.min, way.max);
        const double nearest = std::fmax(0, std::fmax(way.min, -way.max));
        return nearest2 + across2 * nearest * nearest <= part.radii.max * part.radii.max &&
               nearest2 + across2 * farthest * farthest >= part.radii.min * part.radii.min;
    }

    /// 0 where the point of the curve lies on the ray (scaled by rise^2).
    double miss(const Vec2& point) const {
        const double w = point.y - height;
        return across2 * w * w + rise * rise * (nearest2 - point.x * point.x);
    }
};

/// Coefficients of LatheRay::miss() along a piece with `count` coefficients.
std::array<double, 7> miss_along(const LatheRay& ray, const CurvePiece& piece, std::size_t count) {
    std::array<double, 7> result{};
    result[0] = ray.rise * ray.rise * ray.nearest2;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            const Vec2 &a = piece.factors[i], &b = piece.factors[j];
            const double wa = i == 0 ? a.y - ray.height : a.y;
            const double wb = j == 0 ? b.y - ray.height : b.y;
            result[i + j] += ray.across2 * wa * wb - ray.rise * ray.rise * a.x * b.x;
        }
    return result;
}

/// An intersection of ray and curve, with the parameters of both.
struct Meeting {
    double s, u;
};

/// Newton's method for both equations, the distance from the axis and the height. Nearly level rays
/// need it, since they hit the curve in two places close together.
Meeting polished(const LatheRay& ray, const CurvePiece& piece, Meeting m) {
    for (int step = 0; step < 3; ++step) {
        const Vec2 p = piece.at(m.u), slope = piece.slope(m.u);
        const double off = ray.nearest2 + ray.across2 * m.s * m.s - p.x * p.x;
        const double above = ray.height + ray.rise * m.s - p.y;
        const double a = 2 * ray.across2 * m.s, b = -2 * p.x * slope.x;
        const double det = -a * slope.y - b * ray.rise;
        const Meeting next{m.s - (-off * slope.y - b * above) / det,
                           m.u - (a * above - ray.rise * off) / det};
        if (!(std::abs(next.u - m.u) < 1e-2)) return m;
        m = next;
    }
    return m;
}

/// Rays that rise less than this are intersected as level ones and then corrected.
constexpr double level = 1e-6;

template <class Take>
void meet(const LatheRay& ray, const BuiltLathe::Part& part, Take take) {
    const CurvePiece& piece = part.piece;
    if (std::abs(ray.rise) > level) {
        const auto miss = miss_along(ray, piece, part.factors);
        const Roots places = sign_changes(std::span(miss).first(2 * part.factors - 1), {0, 1},
                                          ray.miss(piece.start), ray.miss(piece.end));
        for (const double u : places)
            take(polished(ray, piece, {(piece.at(u).y - ray.height) / ray.rise, u}));
        return;
    }
    const Roots places = sign_changes(piece.combined({0, 1}, -ray.height), {0, 1},
                                      piece.start.y - ray.height, piece.end.y - ray.height);
    for (const double u : places) {
        const double radius = piece.at(u).x, half2 = (radius * radius - ray.nearest2) / ray.across2;
        if (!(half2 > 0)) continue;
        for (const double s : {-std::sqrt(half2), std::sqrt(half2)})
            take(polished(ray, piece, {s, u}));
    }
}

bool is_level(const CurvePiece& piece) {
    const auto& f = piece.factors;
    return f[1].y == 0 && f[2].y == 0 && f[3].y == 0;
}

Box turned(const Rectangle& r) {
    const double reach = std::fmax(std::abs(r.low.x), std::abs(r.high.x));
    return {Vec3(-reach, r.low.y, -reach), Vec3(reach, r.high.y, reach)};
}

BuiltLathe::Part part_of(const CurvePiece& piece, const Rectangle& box) {
    std::size_t factors = piece.factors.size();
    while (factors > 1 && piece.factors[factors - 1] == Vec2(0)) --factors;
    const double reach = std::fmax(std::abs(box.low.x), std::abs(box.high.x));
    const double pad = 1e-9 * (reach + box.high.y - box.low.y);
    const double hollow = std::fmax(0, std::fmax(box.low.x, -box.high.x) - pad);
    return {piece, factors, {hollow, reach + pad}, {box.low.y - pad, box.high.y + pad}};
}

/// Signed area between the piece and the axis: the integral of r dy.
double area(const CurvePiece& piece) {
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 1; j < 4; ++j)
            sum += piece.factors[i].x * piece.factors[j].y * static_cast<double>(j) /
                   static_cast<double>(i + j);
    return sum;
}

}  // namespace

BuiltLathe build(const Lathe& lathe) {
    BuiltLathe result;
    double sum = 0;
    for (const CurvePiece& piece : curve(static_cast<CurveKind>(lathe.spline), lathe.points)) {
        const Rectangle box = bounds(piece);
        result.parts.push_back(part_of(piece, box));
        result.bounds = join(result.bounds, turned(box));
        sum += area(piece);
    }
    result.outside_right = sum >= 0;
    return result;
}

std::string problem(const Lathe& lathe) {
    const auto kind = static_cast<CurveKind>(lathe.spline);
    const std::size_t least = min_points(kind);
    if (lathe.points.size() < least)
        return "a `lathe` with this spline needs at least " + std::to_string(least) + " points";
    if (kind == bezier_curve && lathe.points.size() % 4 != 0)
        return "a `lathe` with `bezier_spline` needs four points for each piece";
    // As in POV-Ray the curve may begin and end beyond the axis.
    const bool in_order = std::all_of(lathe.points.begin() + 1, lathe.points.end() - 1,
                                      [](const Vec2& p) { return p.x >= 0; });
    return in_order || kind != linear_curve
               ? ""
               : "a `lathe` needs radii that are not below 0 between its first and its last point";
}

Box bounds(const BuiltLathe& lathe) { return lathe.bounds; }

/// See count_work(): parts whose bounds are compared.
constexpr std::size_t parts_of_lathe_step = 8;

void crossings(const BuiltLathe& lathe, const Ray& ray, Crossings& found) {
    const double speed = length(ray.direction);
    if (!(speed > 0)) return;
    const Vec3 d = ray.direction / speed;
    const double across2 = d.x * d.x + d.z * d.z;
    const Vec3 centre = lathe.bounds.centre();
    // Starts at the point nearest to the axis; for rays along the axis, at the point nearest to the
    // middle.
    const double start = across2 > 1e-12 ? -(ray.origin.x * d.x + ray.origin.z * d.z) / across2
                                         : dot(centre - ray.origin, d);
    const Ray near{ray.origin + start * d, d};
    const LatheRay seen(near.origin, d);
    count_long_work(lathe.parts.size() / parts_of_lathe_step);
    for (const BuiltLathe::Part& part : lathe.parts) {
        if (!seen.comes_near(part)) continue;
        meet(seen, part, [&](const Meeting& m) {
            const Vec3 p = near.at(m.s);
            Vec2 slope = part.piece.slope(m.u);
            // Beyond the axis the curve is mirrored.
            if (part.piece.at(m.u).x < 0) slope.x = -slope.x;
            const double radius = math::hypot(p.x, p.z), side = lathe.outside_right ? 1 : -1;
            const Vec3 out = radius > 0 ? Vec3(p.x, 0, p.z) / radius : Vec3(0);
            const Vec3 normal = unit(side * (slope.y * out - Vec3(0, slope.x, 0)));
            if (normal == Vec3(0)) return;
            double t = (start + m.s) / speed;
            if (is_level(part.piece))
                t = meeting_with_end(ray, Vec3(0, part.piece.start.y, 0), Vec3(0, 1, 0), t);
            found.add({t, normal, dot(d, normal) < 0});
        });
    }
}

bool inside(const BuiltLathe& lathe, const Vec3& point) {
    const double radius = math::hypot(point.x, point.z);
    bool result = false;
    count_long_work(lathe.parts.size() / parts_of_lathe_step);
    for (const BuiltLathe::Part& part : lathe.parts) {
        if (!part.heights.contains(point.y) || radius > part.radii.max) continue;
        const CurvePiece& piece = part.piece;
        for (const double u : sign_changes(piece.combined({0, 1}, -point.y), {0, 1},
                                           piece.start.y - point.y, piece.end.y - point.y))
            result ^= std::abs(piece.at(u).x) > radius;
    }
    return result;
}

}  // namespace candelabra
