// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the hierarchy that light_bvh walks down: a binary tree with one luminaire in each leaf,
// split where the surface area orientation heuristic of Conty Estevez and Kulla (2018) says.
#pragma once

#include "lighting/light_bvh.h"

namespace candelabra {

/// Nodes depth first; none when there are no luminaires. The tree is never much deeper than 64
/// levels plus a balanced one, however the luminaires lie.
std::vector<LightNode> build_light_hierarchy(std::span<const Luminaire>);

}  // namespace candelabra
