// SPDX-License-Identifier: GPL-3.0-or-later
// Noise and CPU time of a picture, for the benchmarks of light. Noise is that of two pictures with
// different seeds against each other, so no converged picture is needed: half of their mean squared
// difference is the variance of a pixel.
#pragma once

#include "render/render.h"
#include "world/compile.h"

#include <ctime>

#include <cmath>
#include <string>
#include <vector>

namespace candelabra {

inline double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Strategy {
    std::string name;
    LightSampler sampler;
    int samples = 10;
    int shadow_rays = 1;  ///< 0: as many as pay
};

struct Measured {
    double mean = 0, rmse = 0, seconds = 0;
    double work() const { return rmse * std::sqrt(seconds); }
};

inline RenderSettings settings_for(const Strategy& strategy, int size) {
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.antialias = false;
    settings.samples = strategy.samples;
    settings.shadow_rays = strategy.shadow_rays;
    settings.threads = 1;
    return settings;
}

/// Pixels that look straight at a luminaire have no noise; the noise of the others is measured all
/// the same.
inline Measured measure(const Shot& shot, const Strategy& strategy, int size) {
    RenderSettings settings = settings_for(strategy, size);
    const double start = cpu_seconds();
    const Image a = render(shot, settings).image;
    const double end = cpu_seconds();
    settings.seed = 1;
    const Image b = render(shot, settings).image;
    Measured result;
    double squares = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double x = grey(a.pixels[i]), y = grey(b.pixels[i]);
        result.mean += (x + y) / 2;
        squares += (x - y) * (x - y) / 2;
    }
    const auto count = static_cast<double>(a.pixels.size());
    result.mean /= count;
    result.rmse = std::sqrt(squares / count);
    result.seconds = end - start;
    return result;
}

/// Appends what a strategy picks at a point of which nothing else is known.
inline void add_picks(const BuiltLightSampler& built, const Receiver& point, const Key& key,
                      LightSamples& samples) {
    const BsdfLobes lobes;
    std::visit(
        [&](const auto& b) {
            b.at({point, lobes, nullptr, nullptr}).sample(key, samples);
        },
        built);
}

inline LightOctree octree() { return {}; }
inline LightOctree alone() {
    LightOctree result;
    result.alone = true;
    return result;
}
inline LightOctree paper() {
    LightOctree result;
    result.paper = true;
    return result;
}
inline LightBvh pair() {
    LightBvh result;
    result.mis = true;
    return result;
}

}  // namespace candelabra
