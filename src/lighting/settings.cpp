// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/settings.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo EveryLight::vocabulary = described<EveryLight>([] {
    return schema<EveryLight>("every_light",
                              {"A shadow ray to every luminaire at every hit: exact, slow.",
                               "global_settings { light_sampler { every_light } }"});
});

const ItemInfo ConstantAlpha::vocabulary = described<ConstantAlpha>([] {
    return schema<ConstantAlpha>("constant_alpha",
                                 {"Chooses each luminaire with equal probability.",
                                  "global_settings { light_sampler { constant_alpha } }"});
});

const ItemInfo LinearAlpha::vocabulary = described<LinearAlpha>([] {
    return schema<LinearAlpha>(
        "linear_alpha", {"Chooses in proportion to each luminaire's unoccluded contribution, "
                         "which it computes for all of them.",
                         "global_settings { light_sampler { linear_alpha } }"});
});

const ItemInfo LightBvh::vocabulary = described<LightBvh>([] {
    using F = Field<LightBvh>;
    return schema<LightBvh>("light_bvh",
                            {"Walks down a hierarchy of luminaires by importance.",
                             "global_settings { light_sampler { light_bvh } }",
                             "global_settings { light_sampler { light_bvh mis exponential } }"},
                            F{"mis", &LightBvh::mis, flag,
                              "each shadow ray has a partner that the surface chooses; the two are "
                              "weighed against each other (multiple importance sampling)"},
                            F{"exponential", &LightBvh::exponential, flag,
                              "distances in media are drawn by the transmittance alone, as other "
                              "renderers draw them"});
});

const ItemInfo LightOctree::vocabulary = described<LightOctree>([] {
    using F = Field<LightOctree>;
    return schema<LightOctree>(
        "light_octree",
        {"Chooses from a short partition of all luminaires that each cell of space has.",
         "global_settings { light_sampler { light_octree } }",
         "global_settings { light_sampler { light_octree cut 8 eta 0.5 } }",
         "global_settings { light_sampler { light_octree outlook 0.9 max_depth 8 representatives 4 "
         "} }",
         "global_settings { light_sampler { light_octree alone } }",
         "global_settings { light_sampler { light_octree paper threshold 0.01 white 1 max_bright "
         "16 } }"},
        F{"eta", &LightOctree::eta, item,
          "variance over squared mean that the choice may have where nothing is between", above(0)},
        F{"cut", &LightOctree::cut, item,
          "most entries of a cell's partition; up to twice as many where luminaires shine to one "
          "side only",
          between(1, 256)},
        F{"outlook", &LightOctree::outlook, item,
          "greatest share of the shadow rays whose direction is drawn from what a cell sees",
          between(0.5, 0.95)},
        F{"alone", &LightOctree::alone, flag,
          "all shadow rays go to chosen luminaires; cells are not explored by trial"},
        F{"paper", &LightOctree::paper, flag,
          "lists of bright luminaires instead, and guesses for the dim ones"},
        F{"threshold", &LightOctree::threshold, item,
          "paper: a luminaire is bright where it may add this share of white", above(0)},
        F{"white", &LightOctree::white, item, "paper: radiance that the display shows as white",
          above(0)},
        F{"max_depth", &LightOctree::max_depth, item, "deepest level of cells", between(0, 20)},
        F{"max_bright", &LightOctree::max_bright, item,
          "paper: cells with more bright luminaires are subdivided", between(1, 1e6)},
        F{"representatives", &LightOctree::representatives, item,
          "paper: number of dim luminaires sampled at each hit", between(1, 64)});
});

std::vector<IdleField> LightOctree::idle_fields() const {
    std::vector<IdleField> result;
    for (const char* name : {"threshold", "white", "max_bright", "representatives"})
        if (!paper) result.push_back({name, "without `paper`"});
    for (const char* name : {"eta", "cut", "outlook", "alone"})
        if (paper) result.push_back({name, "with `paper`"});
    if (alone && !paper) result.push_back({"outlook", "with `alone`"});
    return result;
}

std::vector<IdleField> idle_fields(const LightSampler& settings) {
    return std::visit(
        [](const auto& s) {
            if constexpr (requires { s.idle_fields(); }) return s.idle_fields();
            return std::vector<IdleField>();
        },
        settings);
}

}  // namespace candelabra
