// SPDX-License-Identifier: GPL-3.0-or-later
// Mappings of a pattern's value before it enters a map: a ramp, up and down, along a sine ...
// Applied by PatternUse as the last step.
#pragma once

#include "pattern/modifiers.h"
#include "vocabulary/kinds.h"

namespace candelabra {

struct RampWave {
    static const ItemInfo vocabulary;
};

struct TriangleWave {
    static const ItemInfo vocabulary;
};

struct SineWave {
    static const ItemInfo vocabulary;
};

struct ScallopWave {
    static const ItemInfo vocabulary;
};

struct CubicWave {
    static const ItemInfo vocabulary;
};

struct PolyWave {
    double exponent = 1;

    static const ItemInfo vocabulary;
};

using Waveform = std::variant<RampWave, TriangleWave, SineWave, ScallopWave, CubicWave, PolyWave>;

/// Returns the value after frequency, phase and wave. Values outside 0..1 are wrapped.
double waved(const Waveform&, const PatternModifiers&, double value);

/// Rises from 0 to 1 and falls back in each unit.
double triangle(double value);
/// sin(2 pi value), accurate for values far from 0.
double cycle(double value);

}  // namespace candelabra
