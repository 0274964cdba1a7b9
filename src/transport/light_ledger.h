// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a rendering, in rays, and the contribution of each light. It is only written while
// light is followed: no decision about rays depends on it.
#pragma once

#include "base/exact_sum.h"
#include "base/function_ref.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// Contribution and cost of the lights of one statement of the scene.
struct LightCount {
    ExactSum light;          ///< grey, as all hits that they light reflect it to their viewers
    std::uint64_t rays = 0;  ///< towards them
    /// The part of it that reached the camera, in samples since the last call of take_lights().
    Vec3 seen = Vec3(0);
};

struct LightLedger {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;     ///< towards luminaires and light sources
    std::uint64_t scattered = 0;  ///< reflected and refracted
    /// One for each of Provenance::light_statements, and a last one for rays that met no luminaire.
    /// Empty if lights are not counted.
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

/// Returns a ledger without counts, with an entry for each statement if lights are `counted`.
LightLedger empty_ledger(const World&, bool counted);

/// Records the light of a directly visible luminaire, as it contributes to the sample.
void record_seen(LightLedger&, const World&, PrimitiveIndex, const Vec3& light);

/// The same for glowing media in those solids: the innermost medium counts.
void record_volume(LightLedger&, const World&, std::span<const PrimitiveIndex> solids,
                   const Vec3& light);

/// Passes on the light of each of Provenance::light_statements in all samples since the last call.
/// Precondition: lights are counted.
void take_lights(LightLedger&, FunctionRef<void(std::size_t statement, const Vec3&)> use);

}  // namespace candelabra
