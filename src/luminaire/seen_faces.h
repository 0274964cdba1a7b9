// SPDX-License-Identifier: GPL-3.0-or-later
// The faces of a glowing box that are visible from a point, and points on them. From outside, the
// faces turned to the point are visible; from inside, all of them.
#pragma once

#include "luminaire/luminaire.h"
#include "luminaire/seen_rectangle.h"

#include <array>
#include <optional>

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
    std::array<std::optional<SeenRectangle>, 6> face_;  ///< none: it is turned away
    std::array<double, 6> share_{};  ///< probability that a point is drawn from each face
    bool any_ = false;
};

}  // namespace candelabra
