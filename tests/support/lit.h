// SPDX-License-Identifier: GPL-3.0-or-later
// What direct light shows of a floor, by itself.
#pragma once

#include "render/direct_light.h"

#include <catch2/catch.hpp>

/// Light at a point of a floor in y, over many keys.
struct Lit {
    double mean = 0;
    double rays = 0;  ///< towards luminaires, at each hit
    double noise = 0;
};
inline Lit lit_at(const World& world, double x, const ShadowRays& shadow_rays, int count) {
    Hit hit;
    const Ray ray{Vec3(x, 3, 0), Vec3(0, -1, 0)};
    REQUIRE(world.first_hit(ray, 0, RayKind::camera, hit));
    DirectLight light(world, shadow_rays);
    RayCounts rays;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        Key key;
        key.sample = static_cast<std::uint32_t>(i);
        const Shading s = shading_at(world, ray, hit);
        const SurfacePlace place(world, hit, s);
        for_layers(*world.material(hit.primitive).texture, s.position, s.normal, place.scene,
                   [&](double, std::span<const Layer> layers) {
                       sum += light(with_layer(world, s, layers.front()), key, rays).x;
                   });
    }
    return {sum / count, static_cast<double>(rays.shadow) / count,
            light.noise().sum / std::max(light.noise().hits, 1)};
}

/// At the origin.
inline double mean_light(const World& world, int shadow_rays, int count) {
    return lit_at(world, 0, shadow_rays, count).mean;
}
