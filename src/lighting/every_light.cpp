// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/every_light.h"

namespace candelabra {

void BuiltEveryLight::choose(const Receiver&, const Key&, LightPicks& picks) const {
    for (LightIndex light = 0; light < count_; ++light) picks.push_back({light, 1});
}

BuiltEveryLight build(const EveryLight&, const LightScene& scene, int) {
    return BuiltEveryLight(scene.count());
}

}  // namespace candelabra
