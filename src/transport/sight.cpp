// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/sight.h"

namespace candelabra {

std::optional<ProbeHit> first_sight(const World& world, const Ray& ray, double tolerance) {
    Hit hit;
    if (!world.first_hit(ray, tolerance, RayKind::light, hit)) return {};
    ProbeHit result{
        dot(hit.position - ray.origin, ray.direction), hit.normal, hit.tolerance, {}, 0};
    const LightIndex light = world.luminaire_of(hit.primitive);
    if (light != no_primitive) {
        const LuminaireAt lamp = world.lights.luminaires[light];
        const Luminaire& luminaire = *lamp;
        result.light = light;
        result.luminance = luminance(radiance_of(world, luminaire, emitting_point(hit, ray)));
    }
    result.passes = luminance(world.passed(hit, ray));
    return result;
}

}  // namespace candelabra
