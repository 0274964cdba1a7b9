// SPDX-License-Identifier: GPL-3.0-or-later
// What may follow every pattern: how its point is disturbed and how its value is repeated. Read
// with the pattern by the evaluator; used by PatternUse and by the patterns that do one of these
// things in a way of their own.
#pragma once

#include "base/noise.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// As POV-Ray stores some numbers: it shows where values meet the keys of a map.
constexpr double single_precision(double x) { return static_cast<float>(x); }

struct PatternModifiers {
    Vec3 turbulence = Vec3(0);
    int octaves = 6;
    double omega = 0.5;
    double lambda = 2;
    int noise_generator = 0;  ///< 0: the scene's
    double frequency = 1;     ///< 0: neither frequency nor phase have an effect
    double phase = 0;

    Octaves noise_octaves() const {
        return {octaves, static_cast<float>(omega), static_cast<float>(lambda)};
    }
    static const ItemInfo vocabulary;
    friend bool operator==(const PatternModifiers&, const PatternModifiers&) = default;
};

/// Where a ray meets a surface, in the space of the scene.
struct SurfaceView {
    Vec3 position;
    Vec3 normal;     ///< unit, on the side of the viewer
    Vec3 direction;  ///< unit, of the ray
};

/// What the scene decides about all patterns, and what only some points have.
struct PatternScene {
    NoiseGenerator noise_generator = NoiseGenerator::full_range;
    int number_of_waves = 10;
    const SurfaceView* view = nullptr;  ///< null: the point is on no surface
    Vec2 uv = Vec2(0);  ///< where the point is on a picture that is wrapped around the surface
};

/// All that a pattern can know: the point in its own space, and what surrounds it.
struct PatternPoint {
    Vec3 position;
    const PatternModifiers& modifiers;
    const PatternScene& scene;

    NoiseGenerator noise_generator() const {
        return modifiers.noise_generator == 0
                   ? scene.noise_generator
                   : candelabra::noise_generator(modifiers.noise_generator);
    }
};

}  // namespace candelabra
