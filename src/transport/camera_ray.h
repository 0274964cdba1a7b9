// SPDX-License-Identifier: GPL-3.0-or-later
// Rays of the world's camera, with the normal that bends them and the lens that blurs them.
#pragma once

#include "base/random.h"
#include "world/world.h"

namespace candelabra {

/// A pixel of a picture of some size.
struct PicturePoint {
    int x, y, width, height;
};

/// Returns the ray through a point of the picture (see Projection::ray) and, if there is a lens, a
/// point of the lens that the key chooses. Its direction is 0 where the camera sees nothing.
Ray camera_ray(const World&, double u, double v, const Key&);

/// Returns the ray through a place of the pixel, given from 0 to 1 from its left and upper edges.
Ray ray_through(const World&, const PicturePoint&, Vec2 place, const Key&);

/// Returns the ray through the centre of the pixel, and of the lens.
Ray middle_ray(const World&, const PicturePoint&);

}  // namespace candelabra
