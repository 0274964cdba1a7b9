// SPDX-License-Identifier: GPL-3.0-or-later
// Modifiers that may follow every pattern: the disturbance of its point and the repetition of its
// value. Read with the pattern by the evaluator; used by PatternUse, and by patterns that apply
// some of them in their own way.
#pragma once

#include "base/noise.h"
#include "vocabulary/item_info.h"

namespace candelabra {

/// Rounds to single precision, as POV-Ray does with some numbers. The difference is visible where
/// values meet the keys of a map.
constexpr double single_precision(double x) { return static_cast<float>(x); }

struct PatternModifiers {
    Vec3 turbulence = Vec3(0);
    int octaves = 6;
    double omega = 0.5;
    double lambda = 2;
    int noise_generator = 0;  ///< 0: the scene's generator
    double frequency = 1;     ///< 0: frequency and phase have no effect
    double phase = 0;

    Octaves noise_octaves() const {
        return {octaves, static_cast<float>(omega), static_cast<float>(lambda)};
    }
    static const ItemInfo vocabulary;
    friend bool operator==(const PatternModifiers&, const PatternModifiers&) = default;
};

/// The point where a ray hits a surface, in world space.
struct SurfaceView {
    Vec3 position;
    Vec3 normal;     ///< unit, on the viewer's side
    Vec3 direction;  ///< unit, of the ray
};

/// How places in pictures rise along a surface, in the space of its normal: a picture whose colours
/// are directions on the surface is turned by them.
struct SurfaceAxes {
    Vec3 u = Vec3(1, 0, 0), v = Vec3(0, 1, 0);  ///< gradients of PatternScene::uv
    Vec3 x = Vec3(1, 0, 0), y = Vec3(0, 1, 0);  ///< of the first two coordinates of the point
    bool by_uv = false;                         ///< the point is a place in u and v
    bool behind = false;                        ///< the inner side of the surface is seen
};

/// Settings of the scene that affect all patterns, and properties that only some points have.
struct PatternScene {
    NoiseGenerator noise_generator = NoiseGenerator::full_range;
    int number_of_waves = 10;
    const SurfaceView* view = nullptr;  ///< null: the point is on no surface
    Vec2 uv = Vec2(0);  ///< coordinates in a picture that is wrapped around the surface
    const SurfaceAxes* axes = nullptr;  ///< null: no pattern needs them
};

/// The input of a pattern: the point in its own space, and its context.
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
