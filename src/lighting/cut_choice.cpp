// SPDX-License-Identifier: GPL-3.0-or-later
#include "lighting/cut_choice.h"

#include <cmath>
#include <limits>

namespace candelabra {

std::optional<OpenPick> open_pick(const LightCut& cut, const CutWeights& weights,
                                  const LightTree& tree, const Receiver& point, const Key& key,
                                  double u, GlossyLobes lobes) {
    if (!(weights.total > 0)) return {};
    double target = u * weights.total;
    const std::size_t entry = cut.find(weights, target);
    const double weight = weights.weight[entry];
    return OpenPick{MemberDraw(tree, cut.cluster(entry), point, key, target / weight, lobes),
                    weight / weights.total};
}

LightPick OpenPick::pick(const LightTree& tree) const {
    const DrawnMember drawn = member.draw();
    return {tree.light(drawn.place),
            std::fmax(of_entry * drawn.probability, std::numeric_limits<double>::min())};
}

std::optional<LightPick> pick_from(const LightCut& cut, const CutWeights& weights,
                                   const LightTree& tree, const Receiver& point, const Key& key,
                                   double u, GlossyLobes lobes) {
    auto open = open_pick(cut, weights, tree, point, key, u, lobes);
    if (!open) return {};
    while (open->member.descend()) {
    }
    return open->pick(tree);
}

double expected_from(const LightCut& cut, const CutWeights& weights, const LightTree& tree,
                     const Receiver& point, LightIndex light, GlossyLobes lobes) {
    if (!(weights.total > 0)) return 0;
    const std::uint32_t place = tree.place_of(light);
    const std::size_t entry = cut.entry_of(place);
    if (entry >= cut.entries()) return 0;
    const LightCluster& c = cut.cluster(entry);
    if (!c.holds(place) || !(weights.weight[entry] > 0)) return 0;
    return weights.weight[entry] / weights.total * probability_of(tree, c, point, place, lobes);
}

}  // namespace candelabra
