// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/primary_hit.h"

#include "transport/vertex.h"

namespace candelabra {

PrimaryHit primary_hit(const World& world, const Ray& ray) {
    PrimaryHit seen;
    if (ray.direction == Vec3(0)) return seen;
    seen.met = world.first_hit(ray, 0, RayKind::camera, seen.hit);
    if (!seen.met) return seen;
    const Vertex vertex = vertex_at(world, ray, seen.hit);
    for (const auto& [weight, layers] : visible_textures(world, vertex)) {
        Rgb through(weight);
        seen.normal += weight * layers.front().normal;
        for (const Layer& layer : layers) {
            seen.albedo += through * layer.colour.rgb * world.opacity(layer.colour);
            through *= layer.colour.passing();
        }
    }
    seen.normal = seen.normal == Vec3(0) ? vertex.shading.normal : unit(seen.normal);
    seen.distance = length(seen.hit.position - ray.origin);
    if (!world.provenance.object_of.empty())
        seen.object = world.provenance.object_of[seen.hit.primitive] + 1;
    return seen;
}

const Texture* texture_at(const World& world, const PrimaryHit& seen) {
    const Texture* dominant = nullptr;
    double greatest = 0;
    if (seen.met)
        world.for_textures(seen.hit.primitive, seen.hit.part, seen.hit.position,
                           seen.hit.side_towards(-seen.normal),
                           [&](double share, const Texture& texture, const Transform*) {
                               if (share <= greatest) return;
                               greatest = share;
                               dominant = &texture;
                           });
    return dominant;
}

}  // namespace candelabra
