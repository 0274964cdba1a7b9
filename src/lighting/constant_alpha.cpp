// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/constant_alpha.h"

namespace candelabra {

void BuiltConstantAlpha::choose(const Receiver& point, const Key& key, LightPicks& picks) const {
    if (count_ == 0) return;
    const auto light =
        static_cast<LightIndex>(uniform(key, Purpose::light_choice) * static_cast<double>(count_));
    picks.push_back({light, expected(point, key, light)});
}

BuiltConstantAlpha build(const ConstantAlpha&, const LightScene& scene, int) {
    return BuiltConstantAlpha(scene.count());
}

}  // namespace candelabra
