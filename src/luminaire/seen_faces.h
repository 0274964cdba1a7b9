// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a glowing box that are visible from a point, and points on them. From outside, the
// faces turned to the point are visible; from inside, all of them.
#pragma once

#include "luminaire/luminaire.h"
#include "luminaire/spherical_rectangle.h"

namespace candelabra {

class SeenFaces {
public:
    /// `box` is in its own space; the transform takes it to world space (null: identity). If the
    /// receiver has a unit normal (null: none), only parts that may be above its horizon are drawn,
    /// and higher faces more often.
    SeenFaces(const Box&, const Transform*, const Vec3& from, const Vec3* normal);

    /// False if the whole box is below the horizon.
    bool any() const { return any_; }

    /// Index of the face across an axis (0 to 2), at its high or low end.
    static int face(int axis, bool high) { return 2 * axis + high; }

    struct Drawn {
        int face;
        LightPoint point;
    };
    /// Returns nothing if rounding puts the receiver in the plane of the face.
    std::optional<Drawn> draw(Vec2 u) const;
    /// Density of a point of the face in the direction of the given unit vector.
    double density(int face, const Vec3& direction, double distance) const;

private:
    struct Face {
        Vec3 corner = Vec3(0), side1 = Vec3(0), side2 = Vec3(0);  ///< in world space; the part that
                                                                  ///< is drawn from
        std::optional<SphericalRectangle> near;  ///< for rectangles that fill much of the view

        /// Cuts off the parts below the horizon; returns false if the whole face is below.
        bool rise_above(const Vec3& from, const Vec3& normal);
        /// Mean sine of the corners' elevation; corners below the horizon count as 0.
        double height(const Vec3& from, const Vec3& normal) const;
    };
    /// Weight of a visible face; 0 if it is below the horizon.
    double weight(Face&, const Vec3* normal) const;

    std::array<Face, 6> face_;
    std::array<double, 6> share_{};  ///< probability that a point is drawn from each face
    bool any_ = false;
    Vec3 from_;
};

}  // namespace candelabra
