// SPDX-License-Identifier: GPL-3.0-or-later
// All light that is sent from lamps before paths start at the camera. All threads of a picture
// share it.
#pragma once

#include "transport/photons.h"
#include "transport/reflected_luminaires.h"

#include <algorithm>

namespace candelabra {

struct SentLight {
    std::shared_ptr<Photons> photons = nullptr;                ///< null: none
    std::shared_ptr<ReflectedLuminaires> reflected = nullptr;  ///< null: none

    /// Light sent for a shot, which must outlive it. `threads`: 0: one per core; the result does
    /// not depend on it.
    static SentLight of(const Shot& shot, int seed, int threads) {
        return {photons_of(shot, seed, threads), reflected_luminaires_of(shot, seed, threads)};
    }

    /// Number of consecutive samples that are served from memory.
    std::uint32_t samples_at_once() const {
        if (!reflected) return Photons::samples_at_once;
        return photons ? std::min(Photons::samples_at_once, ReflectedLuminaires::samples_at_once)
                       : ReflectedLuminaires::samples_at_once;
    }
    explicit operator bool() const { return photons || reflected; }
};

}  // namespace candelabra
