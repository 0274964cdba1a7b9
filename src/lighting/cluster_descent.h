// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of a luminaire of a cluster at a point. Clusters that are near are divided there by
// the estimated light of their halves; in those that are not, the strengths of luminaires decide.
#pragma once

#include "base/random.h"
#include "lighting/light_tree.h"
#include "lighting/lobe_weights.h"

namespace candelabra {

struct DrawnMember {
    std::uint32_t place;  ///< in the tree
    double probability;   ///< among the members of the cluster
};

/// The lobes of a surface with highlights, by which its light is weighed; null: by irradiance.
using GlossyLobes = const LobeWeights<double>*;

/// Draws a member by u in [0, 1). The key makes further numbers where u is used up.
DrawnMember member_of(const LightTree&, LightCluster, const Receiver&, const Key&, double u,
                      GlossyLobes = nullptr);

/// Probability with which member_of() draws a member of the cluster.
double probability_of(const LightTree&, LightCluster, const Receiver&, std::uint32_t place,
                      GlossyLobes = nullptr);

}  // namespace candelabra
