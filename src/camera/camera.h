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

/// All rays start at the camera.
struct Perspective : View {
    static const ItemInfo vocabulary;
};
/// All rays are parallel.
struct Orthographic : View {
    static const ItemInfo vocabulary;
};
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
