// SPDX-License-Identifier: GPL-3.0-or-later
// One luminaire, found by descending a hierarchy: at each node the two halves are weighted by their
// possible light (Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting", 2018). A half has probability 0 only if all of it is below the horizon. Probabilities
// do not depend on the scale of the scene.
#pragma once

#include "base/random.h"
#include "lighting/light_hierarchy.h"
#include "lighting/light_query.h"
#include "lighting/light_scene.h"
#include "lighting/settings.h"

namespace candelabra {

class BuiltLightBvh {
public:
    /// `threads`: 0: one per core; the result does not depend on it.
    explicit BuiltLightBvh(const ChoosableLights&, const LightBvh& = {}, int threads = 1);
    BuiltLightBvh() = default;

    /// The answer at one receiver. If paired, directions are also sampled from the BSDF.
    class At {
    public:
        At(const BuiltLightBvh& bvh, const LightQuery& query)
            : bvh_(bvh), receiver_(query.receiver), bsdf_(bvh.paired() ? query.bsdf : nullptr) {}

        void sample(const Key&, LightSamples&) const;
        double expected(const Key& key, LightIndex light) const {
            return bvh_.expected(receiver_, key, light);
        }
        /// Combines both ways by the balance heuristic (Veach).
        double pdf(const Vec3& direction, double expected, double of_point) const {
            return expected * of_point + (bsdf_ ? bsdf_->pdf(direction) : 0);
        }
        std::optional<LightEstimate> estimate() const { return {}; }
        bool takes_sky() const { return false; }

    private:
        const BuiltLightBvh& bvh_;
        const Receiver& receiver_;
        const BsdfSampler* bsdf_;  ///< null: not paired
    };
    At at(const LightQuery& query) const { return {*this, query}; }

    void choose(const Receiver&, const Key&, LightPicks&) const;
    double expected(const Receiver&, const Key&, LightIndex) const;
    std::size_t memory_bytes() const;

    /// Whether each shadow ray has a partner sampled from the BSDF; there is then a tree to find
    /// the luminaires that the partner hits.
    bool paired() const { return tree_.lights() > 0; }
    const LightTree& tree() const { return tree_; }

private:
    LightTree tree_;
    std::vector<LightNode> nodes_;        ///< depth first; parents before children
    std::vector<std::uint32_t> leaf_of_;  ///< per luminaire
};

BuiltLightBvh build(const LightBvh&, const LightScene&, int threads);

}  // namespace candelabra
