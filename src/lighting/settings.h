// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of each light sampler: part of the scene, chosen by global_settings {
// light_sampler ... } or --light-sampler.
#pragma once

#include "vocabulary/kinds.h"

#include <string_view>
#include <variant>
#include <vector>

namespace candelabra {

/// What other modules ask about a strategy.
struct LightSamplerTraits {
    bool draws = true;                ///< some luminaires by random numbers, instead of taking all
    bool wants_bent_normals = false;  ///< of the lights: see LightBounds
    bool has_cells = false;           ///< in which memory grows while a picture is made
    bool by_transmittance = false;    ///< distances in media are drawn by the transmittance alone
    bool weighs_falloff = false;  ///< of lights, so that it may choose among luminaires and sources
};

/// A field that has no effect with the values of others.
struct IdleField {
    std::string_view name;
    std::string_view why;
};

/// A shadow ray to every luminaire: the conventional way, and the reference against which the
/// others are tested.
struct EveryLight {
    static constexpr LightSamplerTraits traits() { return {.draws = false}; }
    static const ItemInfo vocabulary;
};
/// Every luminaire with the same probability (the paper, section 4.1).
struct ConstantAlpha {
    static constexpr LightSamplerTraits traits() { return {}; }
    static const ItemInfo vocabulary;
};
/// In proportion to the unoccluded contribution of each luminaire (the paper, section 4.2).
struct LinearAlpha {
    static constexpr LightSamplerTraits traits() { return {}; }
    static const ItemInfo vocabulary;
};
/// A hierarchy of luminaires, descended by importance (Conty Estevez and Kulla, "Importance
/// Sampling of Many Lights with Adaptive Tree Splitting", 2018), as in other renderers.
struct LightBvh {
    bool mis = false;
    bool exponential = false;

    LightSamplerTraits traits() const { return {.by_transmittance = exponential}; }
    static const ItemInfo vocabulary;
};
/// An octree whose cells list the luminaires that are bright there (the paper, section 4.3). It is
/// asked for by `light_octree { paper }`.
struct PaperOctree {
    double threshold = 0.0007;
    double white = 1;
    int max_depth = 10;
    int max_bright = 128;
    int representatives = 1;
};
/// An octree whose cells hold short partitions of all luminaires or, if the settings say so, the
/// paper's lists.
struct LightOctree {
    double eta = 0.02;
    int cut = 64;
    int max_depth = 10;
    double outlook = 0.9;
    bool alone = false;
    bool paper = false;
    /// With `paper` only: see PaperOctree.
    double threshold = PaperOctree().threshold;
    double white = PaperOctree().white;
    int max_bright = PaperOctree().max_bright;
    int representatives = PaperOctree().representatives;

    PaperOctree as_in_paper() const {
        return {threshold, white, max_depth, max_bright, representatives};
    }
    LightSamplerTraits traits() const {
        return {.wants_bent_normals = !paper, .has_cells = true, .weighs_falloff = !paper};
    }
    std::vector<IdleField> idle_fields() const;
    static const ItemInfo vocabulary;
};
/// All strategies. GlobalSettings names the default one.
using LightSampler = std::variant<EveryLight, ConstantAlpha, LinearAlpha, LightBvh, LightOctree>;

inline LightSamplerTraits traits(const LightSampler& settings) {
    return std::visit([](const auto& s) { return s.traits(); }, settings);
}

/// Fields that have no effect; none for strategies that do not name any.
std::vector<IdleField> idle_fields(const LightSampler&);

}  // namespace candelabra
