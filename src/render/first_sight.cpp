// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/first_sight.h"

#include "render/shade.h"
#include "render/trace.h"

#include <algorithm>

namespace {

struct Place {
    double u, v;
};

/// As Projection::ray wants it.
Place on_screen(const PicturePoint& at, Vec2 place) {
    return {(at.x + place.x) / at.width - 0.5, 0.5 - (at.y + place.y) / at.height};
}

Ray mesh_ray(const World& world, const PicturePoint& at, Place place, std::uint32_t sample) {
    // As in POV-Ray, where faces stand for pixels the first row is seen twice, and the last never.
    return world.view.camera.mesh->ray(
        {at.x, std::max(at.y - 1, 0), at.width, at.height, sample, place.u + 0.5, place.v + 0.5});
}

}  // namespace

Ray ray_through(const World& world, const PicturePoint& at, Vec2 place, const Key& key) {
    const Place p = on_screen(at, place);
    return world.view.camera.mesh ? mesh_ray(world, at, p, key.sample)
                                  : camera_ray(world, p.u, p.v, key);
}

Ray middle_ray(const World& world, const PicturePoint& at) {
    const Place p = on_screen(at, {0.5, 0.5});
    return world.view.camera.mesh ? mesh_ray(world, at, p, 0) : pinhole_ray(world, p.u, p.v);
}

FirstSight first_sight(const World& world, const Ray& ray) {
    FirstSight seen;
    if (ray.direction == Vec3(0)) return seen;
    seen.met = world.first_hit(ray, 0, RayKind::camera, seen.hit);
    if (!seen.met) return seen;
    const Shading s = shading_at(world, ray, seen.hit);
    const SurfacePlace place(world, seen.hit, s);
    const bool from_inside = dot(seen.hit.normal, ray.direction) > 0;
    for_textures_seen(world, seen.hit, from_inside, [&](double share, const Texture& texture) {
        for_layers(texture, s.position, s.normal, place.scene,
                   [&](double weight, std::span<const Layer> layers) {
                       Vec3 through(share * weight);
                       seen.normal += share * weight * layers.front().normal;
                       for (const Layer& layer : layers) {
                           seen.albedo += through * layer.colour.rgb * world.opacity(layer.colour);
                           through *= layer.colour.passing();
                       }
                   });
    });
    seen.normal = seen.normal == Vec3(0) ? s.normal : unit(seen.normal);
    seen.distance = length(seen.hit.position - ray.origin);
    if (!world.provenance.object_of.empty())
        seen.object = world.provenance.object_of[seen.hit.primitive] + 1;
    return seen;
}

const Texture* texture_at(const World& world, const FirstSight& seen) {
    const Texture* most = nullptr;
    double greatest = 0;
    if (seen.met)
        for_textures_seen(world, seen.hit, dot(seen.hit.normal, seen.normal) < 0,
                          [&](double share, const Texture& texture) {
                              if (share <= greatest) return;
                              greatest = share;
                              most = &texture;
                          });
    return most;
}
