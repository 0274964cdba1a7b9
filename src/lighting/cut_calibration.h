// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration of a cell's cut by shadow rays that are traced when the cell is made: they measure
// how much of the light that its entries promise arrives. Called by the light octree.
#pragma once

#include "lighting/light_cut.h"
#include "lighting/survey_places.h"

namespace candelabra {

/// For each entry of the cut, returns the root mean square of arriving light over the entry's
/// estimate, from a few of its luminaires at a few places. A share is never below a small fraction
/// of the entries' mean, so that each luminaire keeps its chance. All shares are equal if no light
/// arrives.
std::vector<float> arriving_shares(const LightCut&, const LightTree&, const ChoosableLights&,
                                   std::span<const SurveyPlace>, const LightProbe&);

/// The same for an entry of a cell, but at least the fraction that a few rays may miss: near
/// luminaires look different from different points of a cell.
float cautious_share(float share, const Box& cell, const LightProxy&);

/// Total weight of all entries, averaged over the places.
double mean_total(const LightCut&, std::span<const SurveyPlace>);

}  // namespace candelabra
