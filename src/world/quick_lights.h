// SPDX-License-Identifier: GPL-3.0-or-later
// Lights chosen by hierarchies, of which nothing need be found out by trial: for pictures of few
// rays, of which the cells of a light octree would need many more. Used by the preview.
#pragma once

#include "world/world.h"

namespace candelabra {

/// While it lives, the world and its moments choose lights in this way; they must live longer.
class QuickLights {
public:
    explicit QuickLights(World&);
    QuickLights(const QuickLights&) = delete;
    QuickLights& operator=(const QuickLights&) = delete;
    ~QuickLights();

private:
    struct Replaced {
        BuiltLightSampler* place;
        BuiltLightSampler sampler;
    };
    void replace(BuiltLightSampler&, std::span<const Luminaire>);
    void replace_all(World&);

    std::vector<Replaced> replaced_;
};

}  // namespace candelabra
