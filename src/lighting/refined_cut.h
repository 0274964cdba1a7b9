// SPDX-License-Identifier: GPL-3.0-or-later
// The cut through the light tree for the points of one cell: starting from the root, the cluster
// that adds most to the noise of a choice is divided, until there is little noise left or the cut
// has its maximum length.
#pragma once

#include "lighting/light_tree.h"

namespace candelabra {

/// How fine a cut is.
struct CutRule {
    double noise = 0.01;  ///< variance over squared mean of the choice alone, unoccluded
    int max_entries = 64;
};

struct RefinedCut {
    std::vector<LightCluster> clusters;  ///< in the tree's order; without dark ones
    double noise;                        ///< see LightCut::noise()
};

/// Approximate unoccluded contribution of a cluster to the points of a cell.
double weight_in(const Box& cell, const LightTree&, const LightCluster&);

/// A pure function of its arguments.
RefinedCut refined_cut(const LightTree&, const Box& cell, const CutRule&);

}  // namespace candelabra
