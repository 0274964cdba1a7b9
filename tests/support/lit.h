// SPDX-License-Identifier: GPL-3.0-or-later
// What direct light shows of a floor, by itself.
#pragma once

#include "transport/direct_light.h"

#include <catch2/catch.hpp>

namespace candelabra {

/// Light at a point of a floor in y, over many keys.
struct Lit {
    double mean = 0;
    double rays = 0;  ///< towards luminaires, at each hit
    double noise = 0;
};
inline Lit lit_at(const Shot& shot, double x, const ShadowRays& shadow_rays, int count) {
    Hit hit;
    const Ray ray{Vec3(x, 3, 0), Vec3(0, -1, 0)};
    REQUIRE(shot.world->first_hit(ray, 0, RayKind::camera, hit));
    DirectLight light(shot, shadow_rays);
    LightLedger rays;
    const ShadingRules rules = shading_rules(*shot.world);
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        Key key;
        key.sample = static_cast<std::uint32_t>(i);
        const Vertex vertex = vertex_at(*shot.world, ray, hit);
        for (const VisibleTexture& each : visible_textures(*shot.world, vertex)) {
            const Bsdf bsdf(with_layer(*shot.world, vertex, each.layers.front()), rules);
            sum += light({vertex, bsdf, all_light}, key, rays).r;
        }
    }
    return {sum / count, static_cast<double>(rays.shadow) / count,
            rays.noise.sum / std::max(rays.noise.hits, 1)};
}

/// At the origin.
inline double mean_light(const Shot& shot, int shadow_rays, int count) {
    return lit_at(shot, 0, shadow_rays, count).mean;
}

}  // namespace candelabra
