// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/settings.h"

#include "vocabulary/schema.h"

const ItemInfo EveryLight::vocabulary = described<EveryLight>([] {
    return schema<EveryLight>("every_light",
                              "A shadow ray to every luminaire at every hit: exact, slow.");
});

const ItemInfo ConstantAlpha::vocabulary = described<ConstantAlpha>([] {
    return schema<ConstantAlpha>("constant_alpha", "Each luminaire with the same probability.");
});

const ItemInfo LinearAlpha::vocabulary = described<LinearAlpha>([] {
    return schema<LinearAlpha>(
        "linear_alpha",
        "In proportion to each luminaire's unoccluded contribution: asks them all.");
});

const ItemInfo LightBvh::vocabulary = described<LightBvh>([] {
    return schema<LightBvh>("light_bvh", "Walks down a hierarchy of luminaires by importance.");
});

const ItemInfo LightOctree::vocabulary = described<LightOctree>([] {
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
});
