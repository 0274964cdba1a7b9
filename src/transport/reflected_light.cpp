// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_light.h"

#include <cmath>
#include <numbers>

namespace candelabra {

Vec3 ReflectedLight::operator()(const Vertex& vertex, const Shading& s, int reflections,
                                const Vec3& throughput, const Key& key, LightLedger& ledger) {
    const ReflectedSet& set = current();
    const Key own = key.branched(Branch::reflected);
    const Receiver point = receiver(s);
    const BsdfLobes lobes;
    samples_.clear();
    std::visit(
        [&](const auto& strategy) {
            strategy.at({point, lobes, nullptr, nullptr}).sample(own, samples_);
        },
        set.sampler);
    Vec3 sum(0);
    for (const LightPick& pick : samples_.picks) {
        const ReflectedLuminaire& luminaire = set.list[pick.light];
        if (luminaire.reflections > reflections) continue;
        const Vec3 arriving = from(luminaire, vertex, s);
        if (arriving == Vec3(0)) continue;
        ++ledger.shadow;
        const Vec3 offset = luminaire.position - vertex.position();
        const double distance = length(offset);
        if (!is_seen(luminaire, vertex, offset / distance, distance)) continue;
        const Vec3 seen = arriving / pick.expected;
        sum += seen;
        if (ledger.lights.empty()) continue;
        LightCount& count = ledger.lights[luminaire.statement];
        count.light.add(grey(seen));
        count.seen += throughput * seen;
        ++count.rays;
    }
    return sum;
}

double ReflectedLight::share(double cosine, double other_cosine, double distance) const {
    const double geometry = cosine * other_cosine / (distance * distance);
    return geometry > source().bound() ? source().bound() / geometry : 1;
}

/// Radiance towards the viewer by one reflected luminaire, if it is not occluded.
Vec3 ReflectedLight::from(const ReflectedLuminaire& luminaire, const Vertex& vertex,
                          const Shading& s) const {
    const Vec3 offset = luminaire.position - vertex.position();
    const double distance = length(offset);
    if (!(distance > vertex.tolerance())) return Vec3(0);
    const Vec3 direction = offset / distance;
    const double cosine = dot(direction, s.normal), there = -dot(direction, luminaire.normal);
    if (!(cosine > 0 && there > 0)) return Vec3(0);
    return Bsdf(s, rules_).evaluate(direction, diffuse_terms, 0) * luminaire.power *
           (there * share(cosine, there, distance) / (std::numbers::pi * distance * distance));
}

bool ReflectedLight::is_seen(const ReflectedLuminaire& luminaire, const Vertex& vertex,
                             const Vec3& direction, double distance) const {
    const Ray ray{vertex.position(), direction};
    // Clear surfaces occlude, too: paths go through these by themselves.
    if (!world_.appearance.any_clear && !world_.appearance.any_left_out)
        return world_.transmittance(ray, vertex.tolerance(), distance) != Vec3(0);
    Hit hit;
    return !world_.first_hit(ray, vertex.tolerance(), RayKind::gathering, hit) ||
           length(hit.position - ray.origin) > distance - luminaire.tolerance;
}

}  // namespace candelabra
