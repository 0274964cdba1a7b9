// SPDX-License-Identifier: GPL-3.0-or-later
// An octree over the points to be lit, whose cells hold cuts through the light tree: the paper's
// lists of bright luminaires, with clusters in place of the dim ones. A cell is made at the first
// query for a point in it, and is a pure function of its box, so that results do not depend on the
// order of queries. A survey also tells it which light is visible from there: its outlook.
#pragma once

#include "base/random.h"
#include "lighting/light_cut.h"
#include "lighting/light_guide.h"
#include "lighting/light_query.h"
#include "lighting/settings.h"

#include <atomic>
#include <memory>

namespace candelabra {

class BuiltCutOctree {
public:
    /// Weights of luminaires and directions at one point, for several choices and queries there.
    struct Weights : CutWeights {
        const LightCut* cut = nullptr;
        LightGuide::Weights outlook;  ///< if the scene was available
        double by_direction = 0;      ///< fraction of shadow rays to be sampled from the outlook
        bool as_scattered = false;    ///< all shadow rays should be sampled from the BSDF
        /// Expected standard deviation of one shadow ray's irradiance; below 0: not known.
        double noise = -1;
        double irradiance = 0;  ///< expected irradiance; known if the noise is
    };

    class At;

    BuiltCutOctree(const LightOctree&, const LightScene&);
    BuiltCutOctree(BuiltCutOctree&&) noexcept;
    BuiltCutOctree& operator=(BuiltCutOctree&&) noexcept;
    ~BuiltCutOctree();

    At at(const LightQuery&) const;

    /// Precondition: the query has a scene.
    void weigh(const LightQuery&, Weights&) const;
    /// The same without a scene: sets the weights of luminaires, but not those of directions.
    void weigh_choice(const Receiver&, const BsdfLobes&, Weights&) const;
    /// Appends the luminaire for u in [0, 1), if there is one above the horizon.
    void choose(const Receiver&, const Weights&, const Key&, double u, LightPicks&) const;
    double expected(const Receiver&, const Weights&, LightIndex) const;

    void choose(const Receiver&, const Key&, LightPicks&) const;
    double expected(const Receiver&, const Key&, LightIndex) const;

    /// Includes the cells made so far.
    std::size_t memory_bytes() const;
    std::size_t cells() const;
    const LightTree& tree() const;

private:
    struct Cell;
    struct State;

    Cell* cell_in(std::atomic<Cell*>&, const Box&, const Cell& parent, const LightProbe*) const;
    const Cell& cell_at(const Receiver&, const LightProbe*) const;
    std::unique_ptr<Cell> make(const Box&, const Cell& parent, const LightProbe*) const;

    std::unique_ptr<State> state_;
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
    double expected(const Key&, LightIndex light) const {
        return by_choice_ > 0 ? octree_.expected(receiver_, weights_, light) : 0;
    }
    double pdf(const Vec3& direction, double expected, double of_point) const;
    double picked() const { return by_choice_; }
    double noise() const { return weights_.noise; }
    double irradiance() const { return weights_.irradiance; }
    double expected_light() const { return weights_.total; }
    const LightTree* meetings() const { return nullptr; }

private:
    const BuiltCutOctree& octree_;
    const Receiver& receiver_;
    const BsdfSampler* bsdf_;
    Weights weights_;
    /// Fractions of the shadow rays.
    double by_surface_ = 0, by_outlook_ = 0, by_choice_ = 1;
};

inline BuiltCutOctree::At BuiltCutOctree::at(const LightQuery& query) const {
    return {*this, query};
}

}  // namespace candelabra
