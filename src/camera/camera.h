// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras: from a point of the picture to a ray. POV-Ray 3.7's meaning of location, direction,
// right, up, sky, angle and look_at, in its order of evaluation.
#pragma once

#include "base/ray.h"
#include "base/transform.h"
#include "vocabulary/kinds.h"

#include <optional>
#include <string>

/// What every camera has. Left-handed by default: x to the right, y up, z into the picture.
struct View {
    Vec3 location = Vec3(0);
    std::optional<Vec3> direction;
    std::optional<Vec3> right;
    std::optional<Vec3> up;
    Vec3 sky = Vec3(0, 1, 0);
    std::optional<Vec3> look_at;
    std::optional<double> angle;
    Transform transform;  ///< applied after everything else
};

namespace camera_detail {
template <class T>
consteval auto vocabulary(std::string_view name, std::string_view help) {
    using F = Field<T>;
    return schema<T>(name, help, F{"location", &T::location, item, "where it stands"},
                     F{"direction", &T::direction, item,
                       "towards the middle of the picture; its length is the distance of the "
                       "picture plane (default z)"},
                     F{"right", &T::right, item,
                       "from the left edge of the picture to the right (default 1.33 x)"},
                     F{"up", &T::up, item, "from the bottom of the picture to the top (default y)"},
                     F{"sky", &T::sky, item, "what look_at keeps upright"},
                     F{"look_at", &T::look_at, item, "the point in the middle of the picture"},
                     F{"angle", &T::angle, item, "degrees from the left edge to the right",
                       Range{0, 360, true}});
}
}  // namespace camera_detail

/// All rays start at the camera.
struct Perspective : View {
    static consteval auto vocabulary();
};
consteval auto Perspective::vocabulary() {
    return camera_detail::vocabulary<Perspective>("perspective", "All rays start at the camera.");
}

/// All rays are parallel.
struct Orthographic : View {
    static consteval auto vocabulary();
};
consteval auto Orthographic::vocabulary() {
    return camera_detail::vocabulary<Orthographic>("orthographic", "All rays are parallel.");
}

/// Every camera; the first is the one that a block without a type means.
using Camera = std::variant<Perspective, Orthographic>;

/// A camera ready to send rays.
struct Projection {
    Vec3 location, direction, right, up;
    bool parallel = false;  ///< rays start on the picture plane and run along direction

    /// Ray through (u, v): (-1/2, -1/2) is the bottom left corner, (1/2, 1/2) the top right.
    /// Direction of unit length.
    Ray ray(double u, double v) const;
};

/// What is wrong with the camera as a whole, as a sentence; empty when nothing is.
std::string problem(const Camera&);

/// Precondition: problem() is empty.
Projection projection(const Camera&);
