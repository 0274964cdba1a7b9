// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/quadric.h"

#include "base/infinity.h"
#include "vocabulary/schema.h"

#include <optional>

namespace candelabra {

const ItemInfo Quadric::vocabulary = described<Quadric>([] {
    using F = Field<Quadric>;
    return schema<Quadric>("quadric",
                           {"The surface of a polynomial of degree 2; inside it is below 0.",
                            "quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 clipped_by { box { "
                            "-1.3, <1.3, 1.6, 1.3> } } }"},
                           F{"squares", &Quadric::squares, positional, "factors of x^2, y^2, z^2"},
                           F{"products", &Quadric::products, positional, "factors of xy, xz, yz"},
                           F{"linear", &Quadric::linear, positional, "factors of x, y, z"},
                           F{"constant", &Quadric::constant, positional, "what is added"});
});

namespace {

/// The symmetric bilinear form of the quadratic terms.
double product(const Quadric& q, const Vec3& a, const Vec3& b) {
    const Vec3 mixed(a.x * b.y + a.y * b.x, a.x * b.z + a.z * b.x, a.y * b.z + a.z * b.y);
    return dot(q.squares, a * b) + 0.5 * dot(q.products, mixed);
}

double value(const Quadric& q, const Vec3& p) {
    return product(q, p, p) + dot(q.linear, p) + q.constant;
}

Vec3 gradient(const Quadric& q, const Vec3& p) {
    const Vec3& m = q.products;
    return 2.0 * q.squares * p + q.linear +
           Vec3(m.x * p.y + m.y * p.z, m.x * p.x + m.z * p.z, m.y * p.x + m.z * p.y);
}

/// Bounds along the axes in `uses`, those that the quadric has terms with, if the section along
/// them is an ellipsoid (an ellipse, a pair of points): from the inverse of its matrix. Other axes
/// stay infinite.
Box ellipsoid_bounds(const Quadric& q, const std::array<bool, 3>& uses) {
    std::array<Vec3, 3> m = {Vec3(q.squares.x, q.products.x / 2, q.products.y / 2),
                             Vec3(q.products.x / 2, q.squares.y, q.products.z / 2),
                             Vec3(q.products.y / 2, q.products.z / 2, q.squares.z)};
    for (int axis = 0; axis < 3; ++axis)
        if (!uses[axis]) m[axis][axis] = 1;
    const double minor2 = m[0].x * m[1].y - m[0].y * m[1].x;
    const double det = dot(cross(m[0], m[1]), m[2]);
    const double size = max_component(Vec3(m[0].x, m[1].y, m[2].z));
    Box box = everywhere();
    const bool definite =
        m[0].x > 1e-12 * size && minor2 > 1e-12 * size * size && det > 1e-12 * size * size * size;
    if (!definite) return box;
    const std::array<Vec3, 3> inverse = {cross(m[1], m[2]) / det, cross(m[2], m[0]) / det,
                                         cross(m[0], m[1]) / det};
    const Vec3 half = -0.5 * q.linear;
    const Vec3 centre(dot(inverse[0], half), dot(inverse[1], half), dot(inverse[2], half));
    const double depth = -value(q, centre);
    if (!(depth >= 0)) return {};
    for (int axis = 0; axis < 3; ++axis) {
        if (!uses[axis]) continue;
        const double reach = std::sqrt(depth * inverse[axis][axis]);
        box.low[axis] = centre[axis] - reach;
        box.high[axis] = centre[axis] + reach;
    }
    return box;
}

/// Minimum of c t^2 + l t for t from low to high.
double min_square(double c, double l, double low, double high) {
    const auto at = [&](double t) {
        if (c == 0 && l == 0) return 0.0;
        if (std::isfinite(t)) return (c * t + l) * t;
        return c != 0 ? std::copysign(infinity, c) : l * t;
    };
    const double bottom = c > 0 ? -0.5 * l / c : low;
    const double least = std::min(at(low), at(high));
    return bottom > low && bottom < high ? std::min(least, at(bottom)) : least;
}

/// Range of a factor times a coordinate that lies between low and high.
Interval times(double factor, double low, double high) {
    if (factor == 0) return {0, 0};
    return factor > 0 ? Interval{factor * low, factor * high}
                      : Interval{factor * high, factor * low};
}

/// The maximum t with c t^2 + l t + rest <= 0; empty when there is none.
std::optional<double> last_below(double c, double l, double rest) {
    if (!std::isfinite(l) || !std::isfinite(rest)) return std::nullopt;
    if (c == 0) return l > 0 ? std::optional(-rest / l) : std::nullopt;
    const double inner = l * l - 4 * c * rest;
    return c > 0 && inner >= 0 ? std::optional((std::sqrt(inner) - l) / (2 * c)) : std::nullopt;
}

/// The range of one coordinate, from the ranges of the others.
Interval range_within(const Quadric& q, int axis, const Box& box) {
    const int b = (axis + 1) % 3, c = (axis + 2) % 3;
    const auto product = [&](int i, int j) { return q.products[i + j - 1]; };
    const double rest = q.constant +
                        min_square(q.squares[b], q.linear[b], box.low[b], box.high[b]) +
                        min_square(q.squares[c], q.linear[c], box.low[c], box.high[c]) +
                        (product(b, c) == 0 ? 0 : -infinity);
    const Interval slope_b = times(product(axis, b), box.low[b], box.high[b]),
                   slope_c = times(product(axis, c), box.low[c], box.high[c]);
    const double flattest = q.linear[axis] + slope_b.min + slope_c.min,
                 steepest = q.linear[axis] + slope_b.max + slope_c.max;
    Interval range{box.low[axis], box.high[axis]};
    // An extreme slope bounds the term on one side of 0 only. Enlarged against rounding.
    const auto widened = [&](double t) {
        const double end = flattest == steepest ? t : std::max(t, 0.0);
        return end + 1e-9 * (1 + std::abs(end));
    };
    if (const auto last = last_below(q.squares[axis], flattest, rest))
        range.max = std::min(range.max, widened(*last));
    if (const auto first = last_below(q.squares[axis], -steepest, rest))
        range.min = std::max(range.min, -widened(*first));
    return range;
}

}  // namespace

Box bounds_within(const Quadric& q, const Box& box) {
    Box result = box;
    for (int axis = 0; axis < 3; ++axis) {
        const Interval range = range_within(q, axis, result);
        result.low[axis] = range.min;
        result.high[axis] = range.max;
    }
    return result;
}

Box bounds(const Quadric& q) {
    const Vec3 mixed(std::abs(q.products.x) + std::abs(q.products.y),
                     std::abs(q.products.x) + std::abs(q.products.z),
                     std::abs(q.products.y) + std::abs(q.products.z));
    std::array<bool, 3> uses{};
    for (int axis = 0; axis < 3; ++axis)
        uses[axis] = q.squares[axis] != 0 || mixed[axis] != 0 || q.linear[axis] != 0;
    return ellipsoid_bounds(q, uses);
}

void crossings(const Quadric& q, const Ray& ray, Crossings& found) {
    crossings_between(q, ray, {-infinity, infinity}, found);
}

void crossings_between(const Quadric& q, const Ray& ray, const Interval& range, Crossings& found) {
    const Vec3& d = ray.direction;
    const double a = product(q, d, d);
    const double b = 0.5 * dot(gradient(q, ray.origin), d);
    const auto add = [&](double t) {
        if (!range.contains(t)) return;
        const Vec3 normal = unit(gradient(q, ray.at(t)));
        if (normal != Vec3(0)) found.add({t, normal, dot(d, normal) < 0});
    };
    const double sizes = std::abs(q.squares.x) + std::abs(q.squares.y) + std::abs(q.squares.z) +
                         std::abs(q.products.x) + std::abs(q.products.y) + std::abs(q.products.z);
    if (std::abs(a) <= 1e-14 * sizes * dot(d, d)) {
        if (b != 0) add(-0.5 * value(q, ray.origin) / b);
        return;
    }
    // Computed from the middle between the roots, so that a distant origin loses no digits.
    double middle = -b / a;
    middle -= 0.5 * dot(gradient(q, ray.at(middle)), d) / a;
    const double half2 = -value(q, ray.at(middle)) / a;
    if (!(half2 > 0)) return;
    const double half = std::sqrt(half2);
    add(middle - half);
    add(middle + half);
}

bool inside(const Quadric& q, const Vec3& point) { return value(q, point) <= 0; }

std::string vanishes(const Quadric& q) {
    const bool some = q.squares != Vec3(0) || q.products != Vec3(0) || q.linear != Vec3(0);
    return some ? "" : "all its factors besides the constant are 0";
}

}  // namespace candelabra
