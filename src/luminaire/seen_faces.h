// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a glowing box that a point outside sees, and points on them. Used by area
// luminaires, for which boxes are the one shape whose far side never shows.
#pragma once

#include "luminaire/luminaire.h"
#include "luminaire/spherical_rectangle.h"

namespace candelabra {

class SeenFaces {
public:
    /// Of a box in its own space, which the map takes to the world's (null: it is there). Where the
    /// point has a normal (unit; null: none), only what may be above its horizon is drawn, and
    /// faces more often that stand higher.
    SeenFaces(const Box&, const Transform*, const Vec3& from, const Vec3* normal);

    /// False from inside and on the surface, and where all is below the horizon.
    bool any() const { return share_[0] + share_[1] + share_[2] > 0; }

    struct Drawn {
        int axis;  ///< of the face
        LightPoint point;
    };
    /// Nothing where rounding puts the point in the plane of the face.
    std::optional<Drawn> draw(Vec2 u) const;
    /// Density of a point of the face across an axis, in the direction of the given unit vector.
    double density(int axis, const Vec3& direction, double distance) const;

private:
    struct Face {
        Vec3 corner = Vec3(0), side1 = Vec3(0), side2 = Vec3(0);  ///< in the world; what is drawn
        std::optional<SphericalRectangle> near;  ///< of rectangles that fill much of the view

        /// Cuts off what is below the horizon on all of its width; false when all of it is.
        bool rise_above(const Vec3& from, const Vec3& normal);
        /// Mean sine of the corners' heights above it; those below count as 0.
        double height(const Vec3& from, const Vec3& normal) const;
    };
    std::array<Face, 3> face_;
    std::array<double, 3> share_{};  ///< how probably a point is drawn from it
    Vec3 from_;
};

}  // namespace candelabra
