// SPDX-License-Identifier: GPL-3.0-or-later
// Rays of a shot's camera, with the normal that bends them and the lens that blurs them.
#pragma once

#include "base/random.h"
#include "world/shot.h"

namespace candelabra {

/// A pixel of a picture of some size.
struct PicturePoint {
    int x, y, width, height;
};

/// Returns the ray through a point of the picture (see Projection::ray) and, if there is a lens, a
/// point of the lens that the key chooses. Its direction is 0 where the camera sees nothing.
Ray camera_ray(const Shot&, double u, double v, const Key&);

/// Returns the ray through a place of the pixel, given from 0 to 1 from its left and upper edges.
Ray ray_through(const Shot&, const PicturePoint&, Vec2 place, const Key&);

/// Returns the ray through the centre of the pixel, and of the lens.
Ray middle_ray(const World&, const WorldView&, const PicturePoint&);
inline Ray middle_ray(const Shot& shot, const PicturePoint& at) {
    return middle_ray(*shot.world, shot.view, at);
}

}  // namespace candelabra
