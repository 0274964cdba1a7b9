// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray of the camera meets first, and how that looks without light: for layers of pictures,
// and for people who point at a pixel.
#pragma once

#include "base/random.h"
#include "world/world.h"

/// A pixel of a picture of some size.
struct PicturePoint {
    int x, y, width, height;
};

/// Through a place of the pixel, from 0 to 1 from its left and its upper edge. The key chooses the
/// point of a lens.
Ray ray_through(const World&, const PicturePoint&, Vec2 place, const Key&);

/// Through the middle of the pixel, and of a lens.
Ray middle_ray(const World&, const PicturePoint&);

struct FirstSight {
    bool met = false;  ///< otherwise all is 0
    Hit hit;
    Vec3 albedo = Vec3(0);  ///< the colours of all layers, as far as they are opaque
    Vec3 normal = Vec3(0);  ///< unit, towards the viewer, as the surface is shaded
    double distance = 0;    ///< from the ray's origin
    /// From 1 in the order of Provenance::object_spans; 0 also where the world remembers no
    /// objects.
    std::uint32_t object = 0;
};

FirstSight first_sight(const World&, const Ray&);

/// The texture at a place of the surface that counts most there; null when nothing was met.
const Texture* texture_at(const World&, const FirstSight&);
