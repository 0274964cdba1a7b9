// SPDX-License-Identifier: GPL-3.0-or-later
// The first hit of a camera ray, and its appearance without light: for layers of pictures, and for
// users who point at a pixel.
#pragma once

#include "base/rgb.h"
#include "transport/camera_ray.h"

namespace candelabra {

struct PrimaryHit {
    bool met = false;  ///< otherwise all members are 0
    Hit hit;
    Rgb albedo = Rgb(0);    ///< colour of all layers, weighted by their opacity
    Vec3 normal = Vec3(0);  ///< unit shading normal, towards the viewer
    double distance = 0;    ///< from the ray's origin
    /// From 1, in the order of Provenance::object_spans; 0 also if the world does not record
    /// objects.
    std::uint32_t object = 0;
};

PrimaryHit primary_hit(const World&, const Ray&);

/// The dominant texture at that point of the surface; null if the ray met nothing.
const Texture* texture_at(const World&, const PrimaryHit&);

}  // namespace candelabra
