// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_light.h"

#include "transport/direct_light.h"

namespace candelabra {

namespace {

/// Minimum cosine of incidence. Photons below it bring no visible light, and would lead to a
/// division by zero.
constexpr double min_arriving_cosine = 1e-6;

}  // namespace

Vec3 PhotonLight::operator()(const LitLayer& layer, const Key& key, LightLedger& ledger,
                             bool through_surface) {
    const Vec3& point = layer.vertex.position();
    const Vec3& normal = layer.vertex.hit.normal;
    BsdfTerms terms{layer.highlights, !layer.radiosity, FacetLobes::wide};
    const double grain = layer.grain(key);
    Vec3 sum(0);
    current().on_surfaces.around(point, [&](const Photon& photon) {
        if (!layer.light.has(photon.glows ? LightKind::luminaires : LightKind::sources)) return;
        const double density = photon_density(photon, point, normal);
        if (density == 0) return;
        const Vec3 to_light = -Vec3(photon.direction);
        const double cosine = std::abs(dot(to_light, Vec3(photon.normal)));
        if (cosine < min_arriving_cosine) return;
        terms.through_surface = through_surface && !photon.glows;
        // The density on the surface includes the cosine already, and evaluate() applies it again.
        const Vec3 seen = Vec3(photon.power) * (density / cosine) *
                          layer.scatterer.evaluate(to_light, terms, grain);
        sum += seen;
        if (ledger.lights.empty()) return;
        LightCount& own = ledger.lights[photon.statement];
        own.light.add(grey(seen));
        own.seen += layer.throughput * seen;
    });
    return sum;
}

}  // namespace candelabra
