// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of each light sampler: part of the scene, chosen by global_settings {
// light_sampler ... } or --light-sampler.
#pragma once

#include "vocabulary/kinds.h"

namespace candelabra {

/// A shadow ray to every luminaire: the conventional way, and the reference against which the
/// others are tested.
struct EveryLight {
    static const ItemInfo vocabulary;
};
/// Every luminaire with the same probability (the paper, section 4.1).
struct ConstantAlpha {
    static const ItemInfo vocabulary;
};
/// In proportion to the unoccluded contribution of each luminaire (the paper, section 4.2).
struct LinearAlpha {
    static const ItemInfo vocabulary;
};
/// A hierarchy of luminaires, descended by importance (Conty Estevez and Kulla, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting", 2018), as in other renderers.
struct LightBvh {
    bool mis = false;
    bool exponential = false;  ///< distances in media

    static const ItemInfo vocabulary;
};
/// An octree whose cells hold short partitions of all luminaires or, as in the paper (section 4.3),
/// lists of the luminaires that are bright there.
struct LightOctree {
    double eta = 0.02;
    int cut = 64;
    int max_depth = 10;
    double outlook = 0.9;
    bool alone = false;
    bool paper = false;
    double threshold = 0.0007;
    double white = 1;
    int max_bright = 128;
    int representatives = 1;

    static const ItemInfo vocabulary;
};
/// All strategies. GlobalSettings names the default one.
using LightSampler = std::variant<EveryLight, ConstantAlpha, LinearAlpha, LightBvh, LightOctree>;

}  // namespace candelabra
