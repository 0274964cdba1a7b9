// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex that photons have brought there. Called by the direct light.
#pragma once

#include "transport/light_ledger.h"
#include "transport/photons.h"

namespace candelabra {

struct LitLayer;

/// One for each job: it keeps the generation that was asked last.
class PhotonLight {
public:
    PhotonLight() = default;  ///< there is none
    explicit PhotonLight(std::shared_ptr<Photons> photons) : photons_(std::move(photons)) {}

    explicit operator bool() const { return photons_ != nullptr; }

    /// From now on light is of that sample of a pixel, whose generation serves it.
    void begin(std::uint32_t sample) { wanted_ = Photons::generation_of(sample); }

    /// Radiance towards the viewer, by the generation that serves the sample. Precondition:
    /// there are photons, and the layer is one of a surface.
    Vec3 operator()(const LitLayer&, const Key&, LightLedger&);

    /// All that serve the sample. Precondition: there are some.
    const PhotonMaps& maps();

    /// Makes what samples from `first` to before `last` need.
    void prepare(std::uint32_t first, std::uint32_t last) const {
        if (photons_) photons_->prepare(first, last);
    }

private:
    std::shared_ptr<Photons> photons_;
    std::shared_ptr<const PhotonMaps> maps_;
    std::uint32_t wanted_ = 0, generation_ = 0;  ///< that is to serve, and that maps_ is
};

}  // namespace candelabra
