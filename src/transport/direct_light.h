// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a vertex: from POV-Ray's light sources, photons, luminaires and the sky, as far
// as they count there.
#pragma once

#include "base/rgb.h"
#include "transport/chosen_light.h"
#include "transport/source_light.h"

namespace candelabra {

struct PhotonMaps;

/// Radiance towards the viewer by direct light; an unbiased estimate. Each job has its own: it
/// keeps scratch memory.
class DirectLight {
public:
    DirectLight(const Shot& shot, const ShadowRays& rays)
        : world_(*shot.world), rays_(rays.usual), sources_(shot, rays.usual), chosen_(shot, rays) {}

    Rgb operator()(const LitLayer&, const Key&, LightLedger&);
    /// The light that photons bring alone.
    Rgb by_photons(const LitLayer&, const Key&, LightLedger&) const;
    /// The light of one light source, times a weight: nothing if it is in a group that does not
    /// light the material.
    Rgb from_source(std::uint32_t number, double weight, const LitLayer&, const Key&,
                    LightLedger&) const;

    /// Expected irradiance by what the strategy of the shot chooses at a point between surfaces, as
    /// luminance, where it is known. Precondition: there are lights to choose.
    std::optional<double> expected_choice(const Vec3& position) const {
        return chosen_.expected(position);
    }
    /// Sets the photons that count from now on: those that serve the sample. Null: none are shot.
    void use(const PhotonMaps* photons) { photons_ = photons; }
    const PhotonMaps* photons() const { return photons_; }

private:
    ArrivingLight arriving(const LitLayer& layer, LightLedger& ledger) const {
        return {world_, layer, photons_ != nullptr, ledger};
    }

    const World& world_;
    int rays_;
    const PhotonMaps* photons_ = nullptr;
    SourceLight sources_;
    ChosenLight chosen_;
};

}  // namespace candelabra
