// SPDX-License-Identifier: GPL-3.0-or-later
// What a rendering cost, in rays, and which lights gave what. It is only written while light is
// followed: nothing that decides where rays go reads it.
#pragma once

#include "base/exact_sum.h"
#include "base/function_ref.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// What lights of one statement of the scene gave and cost.
struct LightCount {
    ExactSum light;          ///< grey, that came from them to all hits and on to who looks at these
    std::uint64_t rays = 0;  ///< towards them
    /// The part of it that came to the camera in samples which nobody has taken yet.
    Vec3 seen = Vec3(0);
};

struct LightLedger {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;     ///< towards luminaires and light sources
    std::uint64_t scattered = 0;  ///< reflected and refracted
    /// For each of Provenance::light_statements, and at the end for rays that met no luminaire.
    /// Empty when nobody asks.
    std::vector<LightCount> lights = {};

    LightLedger& operator+=(const LightLedger& other) {
        camera += other.camera;
        shadow += other.shadow;
        scattered += other.scattered;
        if (lights.size() < other.lights.size()) lights.resize(other.lights.size());
        for (std::size_t i = 0; i < other.lights.size(); ++i) {
            lights[i].light.add(other.lights[i].light);
            lights[i].rays += other.lights[i].rays;
        }
        return *this;
    }
};

/// One without entries, for the lights of the world one by one where they are `counted`.
LightLedger empty_ledger(const World&, bool counted);

/// Notes the light of a luminaire that is seen itself: what of it comes to the sample.
void record_seen(LightLedger&, const World&, PrimitiveIndex, const Vec3& light);

/// The same of media that glow, in those solids: of the innermost one.
void record_volume(LightLedger&, const World&, std::span<const PrimitiveIndex> solids,
                   const Vec3& light);

/// The light of each of Provenance::light_statements in all samples since the last call. Lights
/// must be counted.
void take_lights(LightLedger&, FunctionRef<void(std::size_t statement, const Vec3&)> use);

}  // namespace candelabra
