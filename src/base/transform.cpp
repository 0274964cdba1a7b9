// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/transform.h"

#include "base/degrees.h"
#include "base/elementary.h"

namespace candelabra {

namespace {

Affine compose(const Affine& first, const Affine& next) {
    Affine result;
    for (int row = 0; row < 3; ++row) result.rows[row] = next.direction(first.rows[row]);
    result.translation = next.point(first.translation);
    return result;
}

Affine invert(const Affine& a) {
    const double d = determinant(a);
    const Vec3 c0 = cross(a.rows[1], a.rows[2]) / d;
    const Vec3 c1 = cross(a.rows[2], a.rows[0]) / d;
    const Vec3 c2 = cross(a.rows[0], a.rows[1]) / d;
    Affine result;
    result.rows = {Vec3(c0.x, c1.x, c2.x), Vec3(c0.y, c1.y, c2.y), Vec3(c0.z, c1.z, c2.z)};
    result.translation = -result.direction(a.translation);
    return result;
}

/// Exact for multiples of a quarter turn, so that rotate 90*y leaves no rounding errors in
/// coordinates.
std::pair<double, double> cos_sin(double degrees) {
    const double turn = std::fmod(degrees, 360);
    if (turn == 0) return {1, 0};
    if (turn == 90 || turn == -270) return {0, 1};
    if (turn == 180 || turn == -180) return {-1, 0};
    if (turn == 270 || turn == -90) return {0, -1};
    return {math::cos(turn * radians_per_degree), math::sin(turn * radians_per_degree)};
}

Affine transpose(const Affine& a) {
    Affine result;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) result.rows[row][column] = a.rows[column][row];
    return result;
}

}  // namespace

Transform::Transform(const Affine& forward) : forward_(forward), backward_(invert(forward)) {}

Transform Transform::translation(const Vec3& offset) {
    Affine forward, backward;
    forward.translation = offset;
    backward.translation = -offset;
    return Transform(forward, backward);
}

Transform Transform::scaling(const Vec3& factors) {
    Affine forward, backward;
    for (int axis = 0; axis < 3; ++axis) {
        forward.rows[axis][axis] = factors[axis];
        backward.rows[axis][axis] = 1 / factors[axis];
    }
    return Transform(forward, backward);
}

Transform Transform::rotation(const Vec3& degrees) {
    const auto [cx, sx] = cos_sin(degrees.x);
    const auto [cy, sy] = cos_sin(degrees.y);
    const auto [cz, sz] = cos_sin(degrees.z);
    Affine x, y, z;
    x.rows = {Vec3(1, 0, 0), Vec3(0, cx, sx), Vec3(0, -sx, cx)};
    y.rows = {Vec3(cy, 0, -sy), Vec3(0, 1, 0), Vec3(sy, 0, cy)};
    z.rows = {Vec3(cz, sz, 0), Vec3(-sz, cz, 0), Vec3(0, 0, 1)};
    const Affine forward = compose(compose(x, y), z);
    return Transform(forward, transpose(forward));
}

Transform Transform::rotation(const Vec3& axis, double degrees) {
    const Vec3 a = unit(axis);
    const auto [c, s] = cos_sin(degrees);
    Affine forward;
    for (int row = 0; row < 3; ++row) {
        Vec3 e(0);
        e[row] = 1;
        forward.rows[row] = c * e + (1 - c) * dot(a, e) * a + s * cross(a, e);
    }
    return Transform(forward, transpose(forward));
}

Box Transform::box(const Box& b) const {
    if (b.empty()) return b;
    // An infinite end stays infinite unless the map turns its axis away.
    const auto scaled = [](double end, const Vec3& row) {
        Vec3 result(0);
        for (int axis = 0; axis < 3; ++axis)
            if (row[axis] != 0) result[axis] = end * row[axis];
        return result;
    };
    Box result{forward_.translation, forward_.translation};
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 from = scaled(b.low[axis], forward_.rows[axis]);
        const Vec3 to = scaled(b.high[axis], forward_.rows[axis]);
        result.low += glm::min(from, to);
        result.high += glm::max(from, to);
    }
    return result;
}

Transform Transform::then(const Transform& next) const {
    return Transform(compose(forward_, next.forward_), compose(next.backward_, backward_));
}

double Transform::uniform_scale() const {
    const auto& r = forward_.rows;
    const double s2 = dot(r[0], r[0]);
    const double tolerance = 1e-12 * s2;
    const bool similar =
        std::abs(dot(r[1], r[1]) - s2) <= tolerance &&
        std::abs(dot(r[2], r[2]) - s2) <= tolerance && std::abs(dot(r[0], r[1])) <= tolerance &&
        std::abs(dot(r[1], r[2])) <= tolerance && std::abs(dot(r[2], r[0])) <= tolerance;
    return similar ? std::sqrt(s2) : 0;
}

}  // namespace candelabra
