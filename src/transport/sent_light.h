// SPDX-License-Identifier: GPL-3.0-or-later
// All light that is sent from lamps before paths come from the camera. A picture has it once, for
// all of its threads.
#pragma once

#include "transport/photons.h"
#include "transport/reflected_luminaires.h"

namespace candelabra {

struct SentLight {
    std::shared_ptr<Photons> photons = nullptr;                ///< null: there are none
    std::shared_ptr<ReflectedLuminaires> reflected = nullptr;  ///< the same

    /// Of a world. `threads`: 0: one per core; nothing depends on it.
    static SentLight of(const World& world, int seed, int threads) {
        return {photons_of(world, seed, threads), reflected_luminaires_of(world, seed, threads)};
    }

    /// So many samples from a first one on are served from memory.
    std::uint32_t samples_at_once() const {
        return reflected ? ReflectedLuminaires::samples_at_once : Photons::samples_at_once;
    }
    explicit operator bool() const { return photons || reflected; }
};

}  // namespace candelabra
