// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_light.h"

#include "transport/shadow_ray.h"

#include <cmath>
#include <cstdint>
#include <numbers>

namespace candelabra {

namespace {

double share_within(double bound, double geometry) {
    return geometry > bound ? bound / geometry : 1;
}

}  // namespace

Rgb ReflectedLight::operator()(const ArrivingLight& at, const Counted& counted, const Key& key) {
    if (!at.layer.scatterer.answers_light()) return Rgb(0);
    const ReflectedSet& set = current();
    const Key own = key.branched(Branch::reflected);
    const Receiver point = receiver(at.layer.scatterer);
    const BsdfLobes lobes;
    samples_.clear();
    std::visit(
        [&](const auto& strategy) {
            const auto answer = strategy.at({point, lobes, nullptr, nullptr});
            for (int i = 0; i < counted.rays; ++i)
                answer.sample(own.part(counted.rays, i), samples_);
        },
        at.layer.scatterer.in_air() ? set.in_air : set.sampler);
    Rgb sum(0);
    for (std::uint32_t i = 0; i < samples_.picks.size(); ++i) {
        LightPick& pick = samples_.picks[i];
        pick.expected *= counted.rays;
        const Key ray = own.with_branch(i);
        const ReflectedLuminaire& luminaire = set.list[pick.light];
        if (luminaire.reflections > counted.reflections) continue;
        if (!luminaire.scattered)
            sum += from(pick, set, at, at.layer.scatterer, ray);
        else if (counted.of_scattered)
            sum += from(pick, set, at, *counted.of_scattered, ray);
    }
    return sum;
}

double ReflectedLight::share(const Vec3& from, const Vec3& normal, double cosine,
                             double other_cosine, double distance) const {
    return share_within(source().bound(from, normal),
                        cosine * other_cosine / (distance * distance));
}

double ReflectedLight::share_in_air(const Vec3& from, double other_cosine, double distance) const {
    return share_within(source().bound_in_air(from), other_cosine / (distance * distance));
}

/// Light of one reflected luminaire. Clear surfaces occlude it, too: paths go through these by
/// themselves.
Rgb ReflectedLight::from(const LightPick& pick, const ReflectedSet& set, const ArrivingLight& at,
                         const Scatterer& scatterer, const Key& key) const {
    const ReflectedLuminaire& luminaire = set.list[pick.light];
    const Vertex& vertex = at.layer.vertex;
    const Vec3 offset = luminaire.position - vertex.position();
    const double distance = length(offset);
    if (!(distance > vertex.tolerance())) return Rgb(0);
    const Vec3 direction = offset / distance;
    const double cosine =
        scatterer.in_air() ? 1 : dot(direction, scatterer.bsdf().shading().normal);
    const double there = luminaire.in_air() ? 1 : -dot(direction, luminaire.normal);
    if (!(cosine > 0 && there > 0)) return Rgb(0);
    const Rgb response = scatterer.evaluate(direction, diffuse_terms, 0);
    const double geometry = cosine * there / (distance * distance);
    const double share = share_within(set.bounds[pick.light], geometry);
    const double sent = luminaire.in_air()
                            ? phase(*luminaire.scattering, -dot(direction, luminaire.normal))
                            : there;
    const Rgb light = luminaire.power * (sent * share / (std::numbers::pi * distance * distance));
    if (response * light == Rgb(0)) return Rgb(0);
    ++at.ledger.shadow;
    const Rgb left = ShadowRay(at, direction, key).left_by_air(distance, luminaire.tolerance);
    return at({luminaire.lamp, response / pick.expected, light * left, 1});
}

}  // namespace candelabra
