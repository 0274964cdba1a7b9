// SPDX-License-Identifier: GPL-3.0-or-later
// What shadow rays that are tried when a cell is made tell of its cut: how much of what its entries
// promise arrives. Called by the light octree.
#pragma once

#include "lighting/light_cut.h"
#include "lighting/light_guide.h"

namespace candelabra {

/// What one shadow ray brings to a place: the light of the luminaire's point for u in [0, 1)^2,
/// over the density of that point per steradian. 0 where none arrives.
double arriving(std::span<const Luminaire>, LightIndex, const SurveyPlace&, const Vec2& u,
                const LightProbe&);

/// For each entry of the cut the root of the mean square of what arrives over what the entry's
/// formula says, by a few luminaires of it at a few places; never below a small share of what the
/// entries have on the whole, so that no luminaire loses its chance. All the same where nothing
/// arrives.
std::vector<float> arriving_shares(const LightCut&, const LightTree&, std::span<const Luminaire>,
                                   std::span<const SurveyPlace>, const LightProbe&);

/// The same for an entry of a cell, but not below what may go unseen by a few rays: what is near is
/// seen in many ways from a cell.
float cautious_share(float share, const Box& cell, const LightProxy&);

/// What all entries weigh together, on average over the places.
double mean_total(const LightCut&, std::span<const SurveyPlace>);

}  // namespace candelabra
