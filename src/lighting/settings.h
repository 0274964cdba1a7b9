// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of each light sampler: part of the scene, chosen by global_settings {
// light_sampler ... } or --light-sampler.
#pragma once

#include "vocabulary/kinds.h"

/// A shadow ray to every luminaire: the conventional way, and the oracle that the others are tested
/// against.
struct EveryLight {
    static consteval auto vocabulary();
};
consteval auto EveryLight::vocabulary() {
    return schema<EveryLight>("every_light",
                              "A shadow ray to every luminaire at every hit: exact, slow.");
}

/// Every luminaire with the same probability (the paper, section 4.1).
struct ConstantAlpha {
    static consteval auto vocabulary();
};
consteval auto ConstantAlpha::vocabulary() {
    return schema<ConstantAlpha>("constant_alpha", "Each luminaire with the same probability.");
}

/// In proportion to the unoccluded contribution of each luminaire (the paper, section 4.2).
struct LinearAlpha {
    static consteval auto vocabulary();
};
consteval auto LinearAlpha::vocabulary() {
    return schema<LinearAlpha>(
        "linear_alpha",
        "In proportion to each luminaire's unoccluded contribution: asks them all.");
}

/// A hierarchy of luminaires, walked down by importance (Conty Estevez and Kulla,
/// "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018): what other renderers
/// do.
struct LightBvh {
    static consteval auto vocabulary();
};
consteval auto LightBvh::vocabulary() {
    return schema<LightBvh>("light_bvh", "Walks down a hierarchy of luminaires by importance.");
}

/// An octree whose cells list the luminaires that are bright there (the paper, section 4.3).
struct LightOctree {
    double threshold = 0.0007;
    double white = 1;
    int max_depth = 12;
    int max_bright = 128;
    int representatives = 1;

    static consteval auto vocabulary();
};
consteval auto LightOctree::vocabulary() {
    using F = Field<LightOctree>;
    return schema<LightOctree>(
        "light_octree",
        "Lists per cell of space the luminaires that are bright there, and guesses the dim ones.",
        F{"threshold", &LightOctree::threshold, item,
          "a luminaire is bright where it may add this share of white", above(0)},
        F{"white", &LightOctree::white, item, "radiance that the display shows as white", above(0)},
        F{"max_depth", &LightOctree::max_depth, item, "deepest level of cells", between(0, 20)},
        F{"max_bright", &LightOctree::max_bright, item,
          "cells with more bright luminaires are subdivided", between(1, 1e6)},
        F{"representatives", &LightOctree::representatives, item,
          "dim luminaires that are asked at each hit", between(1, 64)});
}

/// Every strategy there is. GlobalSettings says which one is the default.
using LightSampler = std::variant<EveryLight, ConstantAlpha, LinearAlpha, LightBvh, LightOctree>;
