// SPDX-License-Identifier: GPL-3.0-or-later
// Where the light tree is cut for the points of one cell: from the whole on, what adds most to the
// noise of a choice is divided, until there is little left or the cut is as long as it may be.
#pragma once

#include "lighting/light_tree.h"

namespace candelabra {

/// How fine a cut is.
struct CutRule {
    double noise = 0.01;  ///< variance over squared mean that the choice alone may have, unoccluded
    int max_entries = 64;
};

struct RefinedCut {
    std::vector<LightCluster> clusters;  ///< in the tree's order; what is dark is left out
    double noise;                        ///< see LightCut::noise()
};

/// A pure function of its arguments.
RefinedCut refined_cut(const LightTree&, const Box& cell, const CutRule&);

}  // namespace candelabra
