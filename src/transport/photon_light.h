// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex from photons. Called by the direct light.
#pragma once

#include "transport/light_ledger.h"
#include "transport/photons.h"

namespace candelabra {

struct LitLayer;

/// Each job has its own: it keeps the generation that was used last.
class PhotonLight {
public:
    PhotonLight() = default;  ///< without photons
    explicit PhotonLight(std::shared_ptr<Photons> photons) : photons_(std::move(photons)) {}

    explicit operator bool() const { return photons_ != nullptr; }

    /// Selects the generation that serves that sample of a pixel.
    void begin(std::uint32_t sample) { wanted_ = Photons::generation_of(sample); }

    /// Radiance towards the viewer, from the generation that serves the sample. Precondition: there
    /// are photons, and the layer is that of a surface.
    Vec3 operator()(const LitLayer&, const Key&, LightLedger&);

    /// Photons that serve the sample. Precondition: there are photons.
    const PhotonMaps& maps();

    /// Builds the generations for samples from `first` to before `last`.
    void prepare(std::uint32_t first, std::uint32_t last) const {
        if (photons_) photons_->prepare(first, last);
    }

private:
    std::shared_ptr<Photons> photons_;
    std::shared_ptr<const PhotonMaps> maps_;
    std::uint32_t wanted_ = 0, generation_ = 0;  ///< to be used, and of maps_
};

}  // namespace candelabra
