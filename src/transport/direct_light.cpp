// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/direct_light.h"

#include "transport/photon_light.h"
#include "transport/photons.h"

#include <numbers>

namespace candelabra {

namespace {

/// Light of the sky from one direction, sampled either where the sky is bright or where the layer
/// responds strongly. The pdf is that of both ways together.
Vec3 from_sky(const ArrivingLight& at, const Key& key, int count) {
    const SkyLight& sky = at.world.sky.light;
    const Scatterer& scatterer = at.layer.scatterer;
    const double u = uniform(key, Purpose::sky_choice);
    const Vec2 place{uniform(key, Purpose::sky_u), uniform(key, Purpose::sky_v)};
    const auto direction =
        u < 0.5 ? std::optional(sky.draw(place).direction) : scatterer.sample(place);
    const Vec3 response = direction ? at.layer.response(*direction, key) : Vec3(0);
    if (response == Vec3(0)) return Vec3(0);
    ++at.ledger.shadow;
    const Vec3 left = ShadowRay(at, *direction, key).left_from_sky();
    const double density = 0.5 * (sky.density(*direction) + scatterer.pdf(*direction));
    const Vec3 light = left == Vec3(0) ? left : left * at.world.sky_radiance(*direction);
    return at({Lamp::sky(), response / (std::numbers::pi * density * count), light, 1});
}

}  // namespace

Vec3 DirectLight::operator()(const LitLayer& layer, const Key& key, LightLedger& ledger) {
    Vec3 sum(0);
    if (!layer.scatterer.answers_light()) return sum;
    const ArrivingLight at = arriving(layer, ledger);
    if (layer.light.has(LightKind::sources)) sum = sources_(at, key);
    if (photons_ && !layer.scatterer.in_air() && layer.collects())
        sum += light_of_photons(photons_->on_surfaces, at, key);
    if (layer.light.has(LightKind::luminaires) && !world_.lights.luminaires.empty())
        sum += luminaires_(at, key, sum);
    if (!layer.light.has(LightKind::sky) || world_.sky.light.empty()) return sum;
    for (int i = 0; i < rays_; ++i) sum += from_sky(at, key.part(rays_, i), rays_);
    return sum;
}

Vec3 DirectLight::from_source(std::uint32_t number, double weight, const LitLayer& layer,
                              const Key& key, LightLedger& ledger) const {
    return sources_.from(number, weight, arriving(layer, ledger), key);
}

}  // namespace candelabra
