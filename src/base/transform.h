// SPDX-License-Identifier: GPL-3.0-or-later
// Affine maps with their inverses, in POV-Ray's row-vector convention: p' = p M, translation in the
// fourth row.
#pragma once

#include "base/box.h"
#include "base/ray.h"
#include "base/vector.h"

#include <array>

namespace candelabra {

/// Three rows of the linear part (images of the x, y and z axes) and a translation.
struct Affine {
    std::array<Vec3, 3> rows = {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
    Vec3 translation = Vec3(0);

    Vec3 direction(const Vec3& v) const { return v.x * rows[0] + v.y * rows[1] + v.z * rows[2]; }
    Vec3 point(const Vec3& p) const { return direction(p) + translation; }
    friend bool operator==(const Affine&, const Affine&) = default;
};

/// Determinant of the linear part: the factor of volumes, negative for reflections.
inline double determinant(const Affine& a) { return dot(cross(a.rows[0], a.rows[1]), a.rows[2]); }

/// An invertible affine map. Both matrices are stored, because rays are transformed backwards and
/// hits forwards.
class Transform {
public:
    Transform() = default;
    /// Precondition: the linear part is not singular (the caller checks determinant() first).
    explicit Transform(const Affine& forward);
    Transform(const Affine& forward, const Affine& backward)
        : forward_(forward), backward_(backward) {}

    static Transform translation(const Vec3& offset);
    /// Factors must not be 0.
    static Transform scaling(const Vec3& factors);
    /// Degrees about x, then y, then z; left-handed sense, as POV-Ray's rotate.
    static Transform rotation(const Vec3& degrees);
    /// Degrees about an axis through the origin (need not be unit, must not be zero).
    static Transform rotation(const Vec3& axis, double degrees);

    Vec3 point(const Vec3& p) const { return forward_.point(p); }
    Vec3 direction(const Vec3& v) const { return forward_.direction(v); }
    /// Image of a surface normal (inverse transpose); not of unit length.
    Vec3 normal(const Vec3& n) const {
        return Vec3(dot(n, backward_.rows[0]), dot(n, backward_.rows[1]),
                    dot(n, backward_.rows[2]));
    }
    Vec3 inverse_point(const Vec3& p) const { return backward_.point(p); }
    Vec3 inverse_direction(const Vec3& v) const { return backward_.direction(v); }
    /// Returns the ray in the space before the map; its parameter t is unchanged.
    Ray inverse_ray(const Ray& r) const {
        return {backward_.point(r.origin), backward_.direction(r.direction)};
    }
    /// Returns the smallest box around the image of a box, which may be infinite in some
    /// directions.
    Box box(const Box& b) const;

    Transform inverse() const { return Transform(backward_, forward_); }
    /// Returns the map that applies this one first, then `next`.
    Transform then(const Transform& next) const;
    const Affine& forward() const { return forward_; }
    double determinant() const { return candelabra::determinant(forward_); }
    /// The factor of all lengths if the map is a similarity; 0 if it is not.
    double uniform_scale() const;
    friend bool operator==(const Transform&, const Transform&) = default;

private:
    Affine forward_;
    Affine backward_;
};

}  // namespace candelabra
