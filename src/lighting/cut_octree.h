// SPDX-License-Identifier: GPL-3.0-or-later
// An octree over the points to be lit, whose cells hold cuts through the light tree: the paper's
// lists of bright luminaires, with clusters in place of the dim ones. A cell is made at the first
// query for a point in it, and is a pure function of its box, so that results do not depend on the
// order of queries. A survey also tells it which light is visible from there: its outlook.
#pragma once

#include "base/random.h"
#include "lighting/cut_choice.h"
#include "lighting/light_cut.h"
#include "lighting/light_guide.h"
#include "lighting/light_query.h"
#include "lighting/light_scene.h"
#include "lighting/settings.h"

#include <atomic>
#include <memory>
#include <span>

namespace candelabra {

struct EntryLook;

class BuiltCutOctree {
public:
    class At;

    /// `threads`: 0: one per core; the result does not depend on it.
    BuiltCutOctree(const LightOctree&, const LightScene&, int threads = 1);
    BuiltCutOctree(BuiltCutOctree&&) noexcept;
    BuiltCutOctree& operator=(BuiltCutOctree&&) noexcept;
    ~BuiltCutOctree();

    At at(const LightQuery&) const;

    /// Includes the cells made so far.
    std::size_t memory_bytes() const;
    std::size_t cells() const;
    /// Precondition: there are lights.
    const LightTree& tree() const;

private:
    struct Cell;
    struct State;

    Cell* cell_in(std::atomic<Cell*>&, const Box&, const Cell& parent, const LightProbe*) const;
    const Cell& cell_at(const Receiver&, const LightProbe*) const;
    std::span<const EntryLook> looks_in(const Cell&) const;
    std::unique_ptr<Cell> make(const Box&, const Cell& parent, const LightProbe*) const;

    std::unique_ptr<State> state_;  ///< null: there are no lights
};

/// The answer at one receiver. A shadow ray has either a direction, sampled from the cell's outlook
/// or from the BSDF, in which all visible luminaires count, or a luminaire and a point on it. Each
/// is weighted by the pdf of all ways together for a point of a luminaire (one-sample multiple
/// importance sampling). So luminaires that the outlook does not know keep their chance, no ray is
/// lost where luminaires hide each other, and luminaires seen only in a highlight cause no
/// fireflies.
class BuiltCutOctree::At {
public:
    At(const BuiltCutOctree&, const LightQuery&);

    void sample(const Key&, LightSamples&) const;
    /// The same for each of several keys and samples, at most draws_together, in less time.
    void sample(std::span<const Key>, std::span<LightSamples>) const;
    double expected(const Key&, LightIndex) const;
    double pdf(const Vec3& direction, double expected, double of_point) const;
    std::optional<LightEstimate> estimate() const;
    bool takes_sky() const { return takes_sky_; }

private:
    void take_weights(const LightQuery&, const Cell&);
    void keep_for_sources();
    std::optional<OpenPick> begin(const Key&, LightSamples&) const;
    void finish(const OpenPick&, LightSamples&) const;
    GlossyLobes lobes() const { return lobes_ ? &*lobes_ : nullptr; }

    const BuiltCutOctree& octree_;
    const Receiver& receiver_;
    const BsdfSampler* bsdf_ = nullptr;  ///< null: no directions are sampled
    const LightCut* cut_ = nullptr;      ///< null: there are no lights
    CutWeights weights_;
    std::optional<LobeWeights<double>> lobes_ = {};  ///< if there are highlights
    LightGuide::Weights outlook_;  ///< if directions are sampled from it
    std::optional<LightEstimate::ShadowRay> ray_ = {};
    std::optional<double> response_ = {};
    /// Fractions of the shadow rays.
    double by_surface_ = 0, by_outlook_ = 0, by_choice_ = 1;
    bool takes_sky_ = false;
    double sky_ = 0;  ///< fraction of the choices that go to the sky
};

inline BuiltCutOctree::At BuiltCutOctree::at(const LightQuery& query) const {
    return {*this, query};
}

}  // namespace candelabra
