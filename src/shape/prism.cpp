// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/prism.h"

#include "base/work_watch.h"
#include "shape/winding.h"
#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Prism::vocabulary = described<Prism>([] {
    using F = Field<Prism>;
    return schema<Prism>(
        "prism",
        {"Closed curves in the xz plane, swept along y.",
         "prism { linear_sweep linear_spline 0, 1.2, 5, <-1, -1>, <1, -1>, <1, 0.5>, <-0.5, 1>, "
         "<-1, -1> open }",
         "prism { cubic_spline 0, 1.2, 7, <-0.5, 1>, <-1, -1>, <1, -1>, <1.1, 0.7>, <-0.5, 1>, "
         "<-1, -1>, <1, -1> }",
         "prism { conic_sweep quadratic_spline 0, 1, 6, <-0.5, 1>, <-1, -1>, <1, -1>, <1.1, 0.7>, "
         "<-0.5, 1>, <-1, -1> scale <1, -1.6, 1> translate 1.6*y }",
         "prism { bezier_spline 0, 1.2, 8, <-1, 0>, <-1, 1.3>, <1, 1.3>, <1, 0>, <1, 0>, <1, "
         "-1.3>, <-1, -1.3>, <-1, 0> }"},
        F{"height1", &Prism::height1, positional, "height of one end"},
        F{"height2", &Prism::height2, positional, "height of the other"},
        F{"points", &Prism::points, counted, "<x, z>, loop after loop; each ends at its start"},
        chooses("linear_sweep", &Prism::sweep, linear_sweep, "keeps the outline's size"),
        chooses("conic_sweep", &Prism::sweep, conic_sweep, "scales the outline by y: a pyramid"),
        chooses("linear_spline", &Prism::spline, linear_curve, "straight between the points"),
        chooses("quadratic_spline", &Prism::spline, quadratic_curve,
                "smooth; the first point of a loop only shapes its curve"),
        chooses("cubic_spline", &Prism::spline, cubic_curve,
                "smooth; the first and last point of a loop only shape its curve"),
        chooses("bezier_spline", &Prism::spline, bezier_curve,
                "each four points are a Bezier curve"),
        F{"open", &Prism::open, flag, "leaves the ends out"});
});

namespace {

Vec2 flat(const Vec3& v) { return {v.x, v.z}; }

/// Whether the section at height y contains the point p of the xz plane.
bool in_section(const BuiltPrism& prism, const Vec2& p, double y) {
    return prism.outline.contains(prism.conic ? p / y : p);
}

/// Projection of the ray along y (or from the apex of a cone) onto the plane of the curves: the
/// line of all points q with dot(weights, q) + constant = 0.
struct Trace {
    Vec2 weights;
    double constant;
};

Trace trace(const BuiltPrism& prism, const Ray& ray) {
    const Vec3 &o = ray.origin, &d = ray.direction;
    if (!prism.conic) return {Vec2(-d.z, d.x), d.z * o.x - d.x * o.z};
    const Vec3 n = cross(o, d);
    return {Vec2(n.x, n.z), n.y};
}

bool misses(const Trace& line, const Rectangle& box) {
    const Vec2 middle = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
    const Vec2 size = glm::abs(line.weights);
    const double reach = glm::dot(size, half);
    return std::abs(glm::dot(line.weights, middle) + line.constant) >
           reach + 1e-12 * (reach + glm::dot(size, glm::abs(middle)));
}

/// Bounds of the projection of the ray between the ends; infinite where it is unbounded.
Rectangle shadow(const BuiltPrism& prism, const Ray& ray) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Rectangle everywhere{Vec2(-infinity), Vec2(infinity)};
    const bool through_apex = prism.conic && prism.bottom <= 0 && prism.top >= 0;
    if (ray.direction.y == 0 || through_apex) return everywhere;
    Rectangle seen;
    for (const double y : {prism.bottom, prism.top}) {
        const Vec2 p = flat(ray.at((y - ray.origin.y) / ray.direction.y));
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return everywhere;
        seen = join(seen, {prism.conic ? p / y : p, prism.conic ? p / y : p});
    }
    const Vec2 rounding = 1e-9 * glm::max(glm::abs(seen.low), glm::abs(seen.high));
    return {seen.low - rounding, seen.high + rounding};
}

/// The ray parameter at which the ray projects to the point of the outline.
double parameter(const BuiltPrism& prism, const Ray& ray, const Vec2& q) {
    const Vec3 &o = ray.origin, &d = ray.direction;
    const Vec2 across = flat(d) - (prism.conic ? d.y * q : Vec2(0));
    const Vec2 to = (prism.conic ? o.y * q : q) - flat(o);
    return glm::dot(across, to) / glm::dot(across, across);
}

Vec3 side_normal(const BuiltPrism& prism, const Outline::Edge& edge, double u, double y) {
    const Vec2 n = edge.normal(u);
    if (!prism.conic) return {n.x, 0, n.y};
    const Vec3 up(n.x, -glm::dot(n, edge.piece.at(u)), n.y);
    return unit(y < 0 ? -up : up);
}

/// Calls use(edge, u, t) for the points of the sides that the ray hits.
template <class Use>
void meet_sides(const BuiltPrism& prism, const Ray& ray, Use use) {
    const Trace line = trace(prism, ray);
    if (line.weights == Vec2(0)) return;
    const Rectangle seen = shadow(prism, ray);
    const auto beside = [&](const Rectangle& box) {
        count_work(1);
        return !overlap(seen, box) || misses(line, box);
    };
    prism.outline.for_edges(beside, [&](const Outline::Edge& edge) {
        const auto at_point = [&](const Vec2& p) {
            return glm::dot(line.weights, p) + line.constant;
        };
        const Roots places = sign_changes(edge.piece.combined(line.weights, line.constant), {0, 1},
                                          at_point(edge.piece.start), at_point(edge.piece.end));
        for (const double u : places) {
            const double t = parameter(prism, ray, edge.piece.at(u)), y = ray.at(t).y;
            if (!(y > prism.bottom && y < prism.top)) continue;
            use(edge, u, t);
        }
    });
}

void cross_sides(const BuiltPrism& prism, const Ray& ray, Crossings& found) {
    meet_sides(prism, ray, [&](const Outline::Edge& edge, double u, double t) {
        const Vec3 normal = side_normal(prism, edge, u, ray.at(t).y);
        found.add({t, normal, dot(ray.direction, normal) < 0});
    });
}

void cross_ends(const BuiltPrism& prism, const Ray& ray, Crossings& found) {
    if (prism.open || ray.direction.y == 0) return;
    // The nearer one first: without a thickness both are at the same t.
    const bool down = ray.direction.y < 0;
    for (const bool entering : {true, false}) {
        const bool top = down == entering;
        const double y = top ? prism.top : prism.bottom;
        const double t = (y - ray.origin.y) / ray.direction.y;
        if (in_section(prism, flat(ray.at(t)), y))
            found.add({t, Vec3(0, top ? 1 : -1, 0), entering});
    }
}

}  // namespace

BuiltPrism build(const Prism& prism) {
    const auto kind = static_cast<CurveKind>(prism.spline);
    // POV-Ray draws Bezier curves backwards.
    std::vector<Vec2> points = prism.points;
    if (kind == bezier_curve) std::ranges::reverse(points);
    return {Outline(closed_curves(kind, points).loops), std::fmin(prism.height1, prism.height2),
            std::fmax(prism.height1, prism.height2), prism.sweep == conic_sweep, prism.open};
}

std::string problem(const Prism& prism) {
    const auto kind = static_cast<CurveKind>(prism.spline);
    const std::size_t least = min_points(kind) + (kind == bezier_curve   ? 0
                                                  : kind == linear_curve ? 1
                                                                         : 2);
    if (prism.points.size() < least)
        return "a `prism` with this spline needs at least " + std::to_string(least) + " points";
    if (kind == bezier_curve && prism.points.size() % 4 != 0)
        return "a `prism` with `bezier_spline` needs four points for each piece";
    if (!closed_curves(kind, prism.points).closed)
        return "a loop of this `prism` does not come back to its start";
    return {};
}

Box bounds(const BuiltPrism& prism) {
    const Rectangle& r = prism.outline.bounds();
    const Box section{Vec3(r.low.x, 0, r.low.y), Vec3(r.high.x, 0, r.high.y)};
    Box box;
    for (const double y : {prism.bottom, prism.top}) {
        const double scale = prism.conic ? y : 1;
        const Vec3 a = scale * section.low, b = scale * section.high;
        box = join(box, {Vec3(0, y, 0) + glm::min(a, b), Vec3(0, y, 0) + glm::max(a, b)});
    }
    if (prism.conic && prism.bottom < 0 && prism.top > 0) box = join(box, Vec3(0));
    return box;
}

void crossings(const BuiltPrism& prism, const Ray& ray, Crossings& found) {
    if (ray.direction == Vec3(0)) return;
    cross_sides(prism, ray, found);
    cross_ends(prism, ray, found);
}

std::optional<bool> outside_right_at(const BuiltPrism& prism, const Ray& ray, double t) {
    std::optional<bool> result;
    double nearest = std::numeric_limits<double>::infinity();
    const auto nearer = [&](double found) {
        const bool is = std::abs(found - t) < nearest;
        if (is) nearest = std::abs(found - t);
        return is;
    };
    meet_sides(prism, ray, [&](const Outline::Edge& edge, double, double found) {
        if (nearer(found)) result = edge.outside_right;
    });
    Crossings ends;
    cross_ends(prism, ray, ends);
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (nearer(ends[i].t)) result.reset();
    return result;
}

bool inside(const BuiltPrism& prism, const Vec3& point) {
    return point.y >= prism.bottom && point.y < prism.top &&
           in_section(prism, flat(point), point.y);
}

}  // namespace candelabra
