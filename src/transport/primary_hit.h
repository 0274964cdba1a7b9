// SPDX-License-Identifier: GPL-3.0-or-later
// What a ray of the camera meets first, and how that looks without light: for layers of pictures,
// and for people who point at a pixel.
#pragma once

#include "transport/camera_ray.h"

namespace candelabra {

struct PrimaryHit {
    bool met = false;  ///< otherwise all is 0
    Hit hit;
    Vec3 albedo = Vec3(0);  ///< the colours of all layers, as far as they are opaque
    Vec3 normal = Vec3(0);  ///< unit, towards the viewer, as the surface is shaded
    double distance = 0;    ///< from the ray's origin
    /// From 1 in the order of Provenance::object_spans; 0 also where the world remembers no
    /// objects.
    std::uint32_t object = 0;
};

PrimaryHit primary_hit(const World&, const Ray&);

/// The texture at a place of the surface that counts most there; null when nothing was met.
const Texture* texture_at(const World&, const PrimaryHit&);

}  // namespace candelabra
