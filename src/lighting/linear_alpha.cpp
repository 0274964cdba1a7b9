// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/linear_alpha.h"

#include <numeric>

namespace candelabra {

BuiltLinearAlpha::BuiltLinearAlpha(const LightScene& scene) : table_(scene.lights) {
    std::vector<LightIndex> lights(scene.count());
    std::iota(lights.begin(), lights.end(), LightIndex{0});
    table_.reserve(1, lights.size());
    all_ = table_.append(lights);
}

void BuiltLinearAlpha::choose(const Receiver& point, const Key& key, LightPicks& picks) const {
    LightTable::Sums sums;
    table_.sum(all_, point, sums);
    if (!(sums.total > 0)) return;
    const auto [row, estimate] =
        table_.find(all_, point, sums, uniform(key, Purpose::light_choice) * sums.total);
    picks.push_back({table_.light(row), estimate / sums.total});
}

double BuiltLinearAlpha::expected(const Receiver& point, const Key&, LightIndex light) const {
    LightTable::Sums sums;
    table_.sum(all_, point, sums);
    return sums.total > 0 ? table_.estimate(light, point) / sums.total : 0;
}

BuiltLinearAlpha build(const LinearAlpha&, const LightScene& scene, int) {
    return BuiltLinearAlpha(scene);
}

}  // namespace candelabra
