// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_light.h"

namespace candelabra {

namespace {

/// Minimum cosine of incidence. Photons below it bring no visible light, and would lead to a
/// division by zero.
constexpr double min_arriving_cosine = 1e-6;

}  // namespace

Rgb light_of_photons(const PhotonMap& map, const ArrivingLight& at, const Key& key) {
    const LitLayer& layer = at.layer;
    const Vec3& point = layer.vertex.position();
    const Vec3& normal = layer.vertex.hit.normal;
    const bool through_surface = passes_surfaces(at.world);
    BsdfTerms terms = layer.terms();
    const double grain = layer.grain(key);
    Rgb sum(0);
    map.around(point, [&](const Photon& photon) {
        const bool of_source = photon.lamp.is_source();
        if (!layer.light.has(of_source ? LightKind::sources : LightKind::luminaires)) return;
        const double density = photon_density(photon, point, normal);
        if (density == 0) return;
        const Vec3 to_light = -Vec3(photon.direction);
        const double cosine = std::abs(dot(to_light, Vec3(photon.normal)));
        if (cosine < min_arriving_cosine) return;
        terms.through_surface = through_surface && of_source;
        // The density on the surface includes the cosine already, and evaluate() applies it again.
        sum += at({photon.lamp, layer.scatterer.evaluate(to_light, terms, grain),
                   rgb_of(photon.power) * (density / cosine)});
    });
    return sum;
}

}  // namespace candelabra
