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

/// Through a point of the picture (see Projection::ray) and, with a lens, a point of that: the key
/// chooses. Its direction is 0 where the camera sees nothing.
Ray camera_ray(const World&, double u, double v, const Key&);

/// Through a place of the pixel, from 0 to 1 from its left and its upper edge.
Ray ray_through(const World&, const PicturePoint&, Vec2 place, const Key&);

/// Through the middle of the pixel, and of a lens.
Ray middle_ray(const World&, const PicturePoint&);

}  // namespace candelabra
