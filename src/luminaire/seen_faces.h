// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a glowing box that a point sees, and points on them: from outside those that face
// it, from within all.
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

    /// False where all is below the horizon.
    bool any() const { return any_; }

    /// The face of a box across an axis (0 to 2), at its high or low end.
    static int face(int axis, bool high) { return 2 * axis + high; }

    struct Drawn {
        int face;
        LightPoint point;
    };
    /// Nothing where rounding puts the point in the plane of the face.
    std::optional<Drawn> draw(Vec2 u) const;
    /// Density of a point of the face, in the direction of the given unit vector.
    double density(int face, const Vec3& direction, double distance) const;

private:
    struct Face {
        Vec3 corner = Vec3(0), side1 = Vec3(0), side2 = Vec3(0);  ///< in the world; what is drawn
        std::optional<SphericalRectangle> near;  ///< of rectangles that fill much of the view

        /// Cuts off what is below the horizon on all of its width; false when all of it is.
        bool rise_above(const Vec3& from, const Vec3& normal);
        /// Mean sine of the corners' heights above it; those below count as 0.
        double height(const Vec3& from, const Vec3& normal) const;
    };
    /// How much counts of a face that is seen; 0 where it is below the horizon.
    double weight(Face&, const Vec3* normal) const;

    std::array<Face, 6> face_;
    std::array<double, 6> share_{};  ///< how probably a point is drawn from it
    bool any_ = false;
    Vec3 from_;
};

}  // namespace candelabra
