// SPDX-License-Identifier: GPL-3.0-or-later
// Points, directions and other small tuples of doubles. The only include of GLM; all other code
// uses Vec3.
#pragma once

#include "base/elementary.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <cmath>
#include <utility>

namespace candelabra {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using glm::cross;
using glm::dot;

namespace math {

/// Of each component.
inline Vec3 exp(const Vec3& v) { return {exp(v.x), exp(v.y), exp(v.z)}; }

}  // namespace math

/// Euclidean length.
inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }

/// v scaled to length 1; the zero vector stays zero.
inline Vec3 unit(const Vec3& v) {
    const double l = length(v);
    return l > 0 ? v / l : Vec3(0);
}

inline double max_component(const Vec3& v) { return std::fmax(v.x, std::fmax(v.y, v.z)); }
inline double min_component(const Vec3& v) { return std::fmin(v.x, std::fmin(v.y, v.z)); }
inline double max_abs_component(const Vec3& v) { return max_component(glm::abs(v)); }

/// Returns two unit vectors that make a right-handed orthonormal frame with the unit vector n. Duff
/// et al., "Building an Orthonormal Basis, Revisited", JCGT 2017: no branch, no singular direction.
/// Zeros of either sign have the same frame: a direction that is turned twice has the samples of
/// the one that is turned by the product.
inline std::pair<Vec3, Vec3> perpendiculars(const Vec3& n) {
    const double sign = n.z < 0 ? -1 : 1;
    const double a = -1 / (sign + n.z);
    const double b = n.x * n.y * a;
    return {Vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x),
            Vec3(b, sign + n.y * n.y * a, -n.y)};
}

/// Returns the unit vector at an angle of this cosine to a unit axis, turned around the axis by
/// `turn` radians.
inline Vec3 turned_from(const Vec3& axis, double cosine, double turn) {
    const double sine = std::sqrt(std::fmax(1 - cosine * cosine, 0));
    const auto [x, y] = perpendiculars(axis);
    return cosine * axis + sine * (math::cos(turn) * x + math::sin(turn) * y);
}

}  // namespace candelabra
