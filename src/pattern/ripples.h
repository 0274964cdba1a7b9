// SPDX-License-Identifier: GPL-3.0-or-later
// Rings that run out from random points on the unit sphere: ripples, which are alike, and waves,
// which are not. The scene says how many points there are.
#pragma once

#include "pattern/modifiers.h"

namespace candelabra {

struct Ripples {
    static const ItemInfo vocabulary;
};

struct Waves {
    static const ItemInfo vocabulary;
};

/// Both use the statement's frequency and phase for the rings; it counts once more for the map.
double evaluate(const Ripples&, const PatternPoint&);
double evaluate(const Waves&, const PatternPoint&);

/// Where rings start.
struct WaveSource {
    Vec3 centre;       ///< on the unit sphere
    double frequency;  ///< of the rings of `waves`
};

/// The first `number` sources; below 1 counts as 1, above max_wave_sources as that.
inline constexpr int max_wave_sources = 1000;
std::span<const WaveSource> wave_sources(int number);

/// The height of the rings of one source at a distance from it, -1 to 1, not divided by anything.
double ring(const PatternModifiers&, double frequency, double distance);

}  // namespace candelabra
