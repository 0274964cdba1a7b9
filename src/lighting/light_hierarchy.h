// SPDX-License-Identifier: GPL-3.0-or-later
// The hierarchy of light_bvh: a binary tree with one luminaire in each leaf, split by the surface
// area orientation heuristic of Conty Estevez and Kulla (2018).
#pragma once

#include "lighting/choosable_lights.h"

#include <vector>

namespace candelabra {

/// A node of the hierarchy: a sphere around its luminaires, and their emission.
struct LightNode {
    Vec3 centre = Vec3(0);
    double radius = 0;
    double intensity = 0;
    glm::vec<3, float> axis{
        0};  ///< middle of the normals of flat luminaires; 0 if light goes in all directions
    float cos_spread = 1, sin_spread = 0;  ///< of half the cone around the axis with all normals
    std::uint32_t parent = 0;
    /// The second child (the first one is the next node); in leaves, the luminaire.
    std::uint32_t second = 0;
    bool leaf = false;
};

/// Nodes depth first, parents before children; none if there are no luminaires. `threads`: 0: one
/// per core; the result does not depend on it.
std::vector<LightNode> build_light_hierarchy(const ChoosableLights&, int threads = 1);

}  // namespace candelabra
