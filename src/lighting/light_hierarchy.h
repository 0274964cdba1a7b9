// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the hierarchy for light_bvh: a binary tree with one luminaire in each leaf, split by the
// surface area orientation heuristic of Conty Estevez and Kulla (2018).
#pragma once

#include "lighting/light_bvh.h"

namespace candelabra {

/// Nodes depth first; none if there are no luminaires. The tree is never much deeper than 64 levels
/// plus those of a balanced one, for any arrangement of luminaires.
std::vector<LightNode> build_light_hierarchy(std::span<const Luminaire>);

}  // namespace candelabra
