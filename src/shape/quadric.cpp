// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/quadric.h"

#include "vocabulary/schema.h"

const ItemInfo Quadric::vocabulary = described<Quadric>([] {
    using F = Field<Quadric>;
    return schema<Quadric>("quadric",
                           "The surface of a polynomial of degree 2; inside it is below 0.",
                           F{"squares", &Quadric::squares, positional, "factors of x^2, y^2, z^2"},
                           F{"products", &Quadric::products, positional, "factors of xy, xz, yz"},
                           F{"linear", &Quadric::linear, positional, "factors of x, y, z"},
                           F{"constant", &Quadric::constant, positional, "what is added"});
});

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The symmetric bilinear form of the second degree's part.
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

/// The part of the solid's extent along the given axes, when its section with them is an ellipsoid
/// (an ellipse, a pair of points): from the inverse of its matrix. Other axes stay infinite.
/// `uses` tells which axes the quadric has terms with.
Box ellipsoid_bounds(const Quadric& q, const std::array<bool, 3>& uses) {
    std::array<Vec3, 3> m = {Vec3(q.squares.x, q.products.x / 2, q.products.y / 2),
                             Vec3(q.products.x / 2, q.squares.y, q.products.z / 2),
                             Vec3(q.products.y / 2, q.products.z / 2, q.squares.z)};
    for (int axis = 0; axis < 3; ++axis)
        if (!uses[axis]) m[axis][axis] = 1;
    const double minor2 = m[0].x * m[1].y - m[0].y * m[1].x;
    const double det = dot(cross(m[0], m[1]), m[2]);
    const double size = max_component(Vec3(m[0].x, m[1].y, m[2].z));
    Box box{Vec3(-infinity), Vec3(infinity)};
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

}  // namespace

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
    const Vec3& d = ray.direction;
    const double a = product(q, d, d);
    const double b = 0.5 * dot(gradient(q, ray.origin), d);
    const auto add = [&](double t) {
        const Vec3 normal = unit(gradient(q, ray.at(t)));
        if (normal != Vec3(0)) found.add({t, normal, dot(d, normal) < 0});
    };
    const double sizes = std::abs(q.squares.x) + std::abs(q.squares.y) + std::abs(q.squares.z) +
                         std::abs(q.products.x) + std::abs(q.products.y) + std::abs(q.products.z);
    if (std::abs(a) <= 1e-14 * sizes * dot(d, d)) {
        if (b != 0) add(-0.5 * value(q, ray.origin) / b);
        return;
    }
    // From the middle between the roots, where a far origin costs no digits.
    double middle = -b / a;
    middle -= 0.5 * dot(gradient(q, ray.at(middle)), d) / a;
    const double half2 = -value(q, ray.at(middle)) / a;
    if (!(half2 > 0)) return;
    const double half = std::sqrt(half2);
    add(middle - half);
    add(middle + half);
}

bool inside(const Quadric& q, const Vec3& point) { return value(q, point) <= 0; }

std::string problem(const Quadric& q) {
    const bool some = q.squares != Vec3(0) || q.products != Vec3(0) || q.linear != Vec3(0);
    return some ? "" : "a `quadric` needs a factor that is not 0 besides the constant";
}
