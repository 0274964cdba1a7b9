// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of a rendering, in rays, and the contribution of each lamp. It is only written while
// light is followed: no ray depends on it. Lamps are told apart by the statements that made them;
// light that is followed knows its lamp only.
#pragma once

#include "base/exact_sum.h"
#include "base/function_ref.h"
#include "base/rgb.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// Contribution and cost of the lamps of one statement of the scene.
struct LightCount {
    ExactSum light;          ///< grey, as all hits that they light reflect it to their viewers
    std::uint64_t rays = 0;  ///< towards them
    /// The part of it that reached the camera, in samples since the last call of take_lights().
    Rgb seen = Rgb(0);
};

/// Light of a lamp in a sample, as it contributes to the pixel.
struct LampPart {
    Lamp lamp;
    Rgb light;
    bool seen;  ///< of a lamp that a ray met, such as the camera's or that of a mirror
};

/// Expected noise of one shadow ray (see ShadowRays), over many hits.
struct HitNoise {
    double sum = 0, squares = 0;
    int hits = 0;

    void add(double noise) { *this += {noise, noise * noise, 1}; }
    HitNoise& operator+=(const HitNoise& other) {
        sum += other.sum;
        squares += other.squares;
        hits += other.hits;
        return *this;
    }
};

struct LightLedger {
    std::uint64_t camera = 0;
    std::uint64_t shadow = 0;     ///< towards luminaires and light sources
    std::uint64_t scattered = 0;  ///< reflected and refracted
    HitNoise noise = {};          ///< of all hits at which it was known
    /// One for each of Provenance::light_statements, and a last one for rays that met no luminaire.
    /// Empty if lights are not counted.
    std::vector<LightCount> lights = {};
    /// Light of the last sample that the first surface or the sky emits: what the camera
    /// sees of things that glow.
    Rgb glow = Rgb(0);
    /// Of the lamps that it counts; null if lights are not counted.
    const Provenance* provenance = nullptr;
    bool keeps_parts = false;          ///< fills `parts`; only if lights are counted
    std::vector<LampPart> parts = {};  ///< of the last sample, in the order of its path

    /// Records light of a lamp that a surface or a medium reflects to its viewer, and the number of
    /// rays towards the lamp. `throughput` is that of the viewer's ray in the sample.
    void add_reflected(Lamp, const Rgb& radiance, const Rgb& throughput, std::uint64_t rays = 0);
    /// Records light of a lamp that is seen directly, as it contributes to the sample.
    void add_visible(Lamp, const Rgb& light);
    /// Records a ray that met no lamp.
    void add_miss();

    LightLedger& operator+=(const LightLedger&);
};

/// Returns a ledger without counts, with an entry for each statement if lights are `counted`, or
/// the `parts` of lamps are kept. The world must outlive it.
LightLedger empty_ledger(const World&, bool counted, bool parts = false);

/// Records the light of a directly visible primitive, if it is a luminaire; `no_primitive` is none.
void record_seen(LightLedger&, const World&, PrimitiveIndex, const Rgb& light);

/// The same for glowing media in those solids: the innermost medium counts.
void record_volume(LightLedger&, const World&, std::span<const PrimitiveIndex> solids,
                   const Rgb& light);

/// Passes on the light of each of Provenance::light_statements in all samples since the last call.
/// Precondition: lights are counted.
void take_lights(LightLedger&, FunctionRef<void(std::size_t statement, const Rgb&)> use);

}  // namespace candelabra
