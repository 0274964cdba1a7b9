// SPDX-License-Identifier: GPL-3.0-or-later
// Light from photons. Each generation is a photon map that is shot anew, and serves some samples of
// all pixels. The radii shrink by a fixed law (Knaus and Zwicker, "Progressive Photon Mapping: A
// Probabilistic Approach", 2011), so that the mean over ever more generations has neither noise nor
// blur. A generation is a function of world, seed and number, and is made on the first request,
// from any thread.
#pragma once

#include "transport/air_photons.h"
#include "transport/generations.h"
#include "transport/photon_map.h"
#include "transport/photon_path.h"

namespace candelabra {

/// The photon maps of one generation.
struct PhotonMaps {
    PhotonMap on_surfaces;
    AirPhotonMap in_air;
};

class Photons {
public:
    /// The shot must outlive this, and its world must have targets. `threads`: 0: one per core; the
    /// result does not depend on it.
    Photons(const Shot&, int seed, int threads);

    /// See generation_serving().
    static constexpr std::uint32_t single_samples = 16, shared_samples = 4;
    /// Number of consecutive samples that are served from memory.
    static constexpr std::uint32_t samples_at_once = 128;

    std::shared_ptr<const PhotonMaps> generation(std::uint32_t number);

private:
    std::vector<Photon> shot(std::uint32_t count, std::uint64_t stream) const;
    void shoot(std::uint32_t first, std::uint32_t last, std::uint32_t count, std::uint64_t stream,
               std::vector<Photon>&) const;
    PhotonMaps made(std::uint32_t number) const;

    const World& world_;
    PhotonShooter shooter_;
    PhotonPaths paths_;
    std::uint32_t count_;
    std::uint64_t seed_;
    int threads_;
    Generations<PhotonMaps> generations_;
};

/// Null where the world has no photon targets.
std::shared_ptr<Photons> photons_of(const Shot&, int seed, int threads);

}  // namespace candelabra
