// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/direct_light.h"

#include "transport/photon_light.h"
#include "transport/photons.h"
#include "transport/sky_at_layer.h"

#include <numbers>

namespace candelabra {

namespace {

/// Light of the sky from one direction.
Rgb from_sky(const ArrivingLight& at, const Key& key, int count) {
    const SkyAtLayer sky(at, key);
    const auto direction = sky.draw();
    const Rgb response = direction ? at.layer.response(*direction, key) : Rgb(0);
    if (response == Rgb(0)) return Rgb(0);
    return sky.from(*direction, response / (std::numbers::pi * sky.density(*direction) * count));
}

}  // namespace

Rgb DirectLight::operator()(const LitLayer& layer, const Key& key, LightLedger& ledger) {
    Rgb sum(0);
    if (!layer.scatterer.answers_light()) return sum;
    const ArrivingLight at = arriving(layer, ledger);
    if (layer.light.has_any(all_sources)) sum = sources_(at, key);
    sum += by_photons(layer, key, ledger);
    bool sky = layer.light.has(LightKind::sky) && !world_.sky.light.empty();
    if (const LightKinds kinds = chosen_.kinds_at(layer); kinds.has_any(all_light)) {
        const ChosenLight::Found found = chosen_(at, key, kinds, sum);
        sum += found.radiance;
        sky &= !found.with_sky;
    }
    if (!sky) return sum;
    for (int i = 0; i < rays_; ++i) sum += from_sky(at, key.part(rays_, i), rays_);
    return sum;
}

Rgb DirectLight::by_photons(const LitLayer& layer, const Key& key, LightLedger& ledger) const {
    if (!photons_ || layer.scatterer.in_air() || !layer.collects()) return Rgb(0);
    return light_of_photons(photons_->on_surfaces, arriving(layer, ledger), key);
}

Rgb DirectLight::from_source(std::uint32_t number, double weight, const LitLayer& layer,
                             const Key& key, LightLedger& ledger) const {
    if (!world_.reaches(world_.lights.reach[number].group, *layer.vertex.material)) return Rgb(0);
    return light_of_source(number, weight, arriving(layer, ledger), key);
}

}  // namespace candelabra
