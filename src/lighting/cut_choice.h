// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of a luminaire from a cut that was weighed at a point: of an entry by the weights, and
// of a luminaire of the entry by cluster_descent.h.
#pragma once

#include "base/random.h"
#include "lighting/cluster_descent.h"
#include "lighting/light_cut.h"

#include <optional>

namespace candelabra {

/// Returns a luminaire for u in [0, 1); nothing if all weights are 0. The key makes further numbers
/// where u is used up.
std::optional<LightPick> pick_from(const LightCut&, const CutWeights&, const LightTree&,
                                   const Receiver&, const Key&, double u, GlossyLobes = nullptr);

/// A choice whose luminaire is still to be drawn from its entry.
struct OpenPick {
    MemberDraw member;
    double of_entry;  ///< probability

    /// Precondition: the member's descent is complete.
    LightPick pick(const LightTree&) const;
};
/// Chooses the entry for pick_from(). What it refers to must outlive the result.
std::optional<OpenPick> open_pick(const LightCut&, const CutWeights&, const LightTree&,
                                  const Receiver&, const Key&, double u, GlossyLobes = nullptr);

/// Expected number of times that pick_from() returns the luminaire.
double expected_from(const LightCut&, const CutWeights&, const LightTree&, const Receiver&,
                     LightIndex, GlossyLobes = nullptr);

}  // namespace candelabra
