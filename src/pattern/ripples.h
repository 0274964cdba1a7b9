// SPDX-License-Identifier: GPL-3.0-or-later
// Rings that spread from random points on the unit sphere: ripples have equal rings, waves differ.
// The scene sets the number of points.
#pragma once

#include "pattern/modifiers.h"

namespace candelabra {

struct Ripples {
    static const ItemInfo vocabulary;
};

struct Waves {
    static const ItemInfo vocabulary;
};

/// Both apply the statement's frequency and phase to the rings; PatternUse applies them again to
/// the value.
double evaluate(const Ripples&, const PatternPoint&);
double evaluate(const Waves&, const PatternPoint&);

/// The centre of a set of rings.
struct WaveSource {
    Vec3 centre;       ///< on the unit sphere
    double frequency;  ///< of the rings of `waves`
};

/// Returns the first `number` sources, where `number` is clamped to 1..max_wave_sources.
inline constexpr int max_wave_sources = 1000;
std::span<const WaveSource> wave_sources(int number);

/// Height of the rings of one source at a distance from it, -1 to 1, without normalisation.
double ring(const PatternModifiers&, double frequency, double distance);

}  // namespace candelabra
