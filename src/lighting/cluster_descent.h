// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of a luminaire of a cluster at a point. Clusters that are near are divided there by
// the estimated light of their halves; in those that are not, the strengths of luminaires decide.
#pragma once

#include "base/random.h"
#include "lighting/light_tree.h"
#include "lighting/lobe_weights.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace candelabra {

struct DrawnMember {
    std::uint32_t place;  ///< in the tree
    double probability;   ///< among the members of the cluster
};

/// The lobes of a surface with highlights, by which its light is weighed; null: by irradiance.
using GlossyLobes = const LobeWeights<double>*;

/// The draw of a member of a cluster by u in [0, 1). The key makes further numbers where u is used
/// up. The tree, the receiver and the lobes must outlive it.
class MemberDraw {
public:
    MemberDraw(const LightTree&, const LightCluster&, const Receiver&, const Key&, double u,
               GlossyLobes = nullptr);

    /// Goes on to a half of the cluster; false if the member is drawn from the cluster as a whole.
    bool descend();
    /// Draws it. Precondition: descend() has returned false.
    DrawnMember draw() const;

private:
    const LightTree* tree_;
    const Receiver* point_;
    GlossyLobes lobes_;
    Key key_;
    LightCluster cluster_;
    std::optional<LightProxy> proxy_ = {};  ///< of the cluster; none: it is the first one
    double u_;
    double probability_ = 1, since_fresh_ = 1;
    std::uint64_t level_ = 1;
};

/// Number of draws among many lights that are worth making together.
inline constexpr std::size_t draws_together = 16;

/// Completes the descents of at most draws_together draws. While one of them waits for the memory
/// of its next clusters, the others go on.
void descend_together(std::span<MemberDraw* const>);

/// Draws a member alone.
DrawnMember member_of(const LightTree&, LightCluster, const Receiver&, const Key&, double u,
                      GlossyLobes = nullptr);

/// Probability with which member_of() draws a member of the cluster.
double probability_of(const LightTree&, LightCluster, const Receiver&, std::uint32_t place,
                      GlossyLobes = nullptr);

}  // namespace candelabra
