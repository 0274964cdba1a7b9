// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a vertex: from POV-Ray's light sources, photons, luminaires and the sky, as far
// as they count there.
#pragma once

#include "transport/luminaire_light.h"
#include "transport/photon_light.h"
#include "transport/source_light.h"

namespace candelabra {

/// Radiance towards the viewer by direct light; an unbiased estimate. Each job has its own: it
/// keeps scratch memory.
class DirectLight {
public:
    /// `photons`: null where there are none.
    DirectLight(const Shot& shot, const ShadowRays& rays,
                std::shared_ptr<Photons> photons = nullptr)
        : world_(*shot.world),
          rays_(rays.usual),
          photons_(std::move(photons)),
          sources_(shot, rays.usual),
          luminaires_(shot, rays) {}

    Vec3 operator()(const LitLayer&, const Key&, LightLedger&);
    /// The same by one light source, times a weight.
    Vec3 from_source(std::uint32_t number, double weight, const LitLayer&, const Key&,
                     LightLedger&) const;

    /// Expected light of luminaires at a point between surfaces, up to a constant factor, where it
    /// is known. Precondition: there are luminaires.
    std::optional<double> expected_luminaires(const Vec3& position) const {
        return luminaires_.expected(position);
    }
    /// Selects the sample that is followed from now on.
    void begin(std::uint32_t sample) { photons_.begin(sample); }
    const PhotonLight& photons() const { return photons_; }
    PhotonLight& photons() { return photons_; }

private:
    ArrivingLight arriving(const LitLayer& layer, LightLedger& ledger) const {
        return {world_, layer, static_cast<bool>(photons_), ledger};
    }

    const World& world_;
    int rays_;
    PhotonLight photons_;
    SourceLight sources_;
    LuminaireLight luminaires_;
};

}  // namespace candelabra
