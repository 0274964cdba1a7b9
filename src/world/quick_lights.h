// SPDX-License-Identifier: GPL-3.0-or-later
// Light sampling by hierarchies, without surveys of the scene: for pictures of few rays, as the
// cells of a light octree would need many more. Used by the preview.
#pragma once

#include "world/world.h"

namespace candelabra {

/// During its lifetime, the world and its moments sample lights by hierarchies. They must outlive
/// it.
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
    void replace(BuiltLightSampler&, const ChoosableLights&);
    void replace_all(World&);

    std::vector<Replaced> replaced_;
};

}  // namespace candelabra
