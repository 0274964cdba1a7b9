// SPDX-License-Identifier: GPL-3.0-or-later
// An octree over the points to be lit, whose cells hold cuts through the light tree: the paper's
// lists of bright luminaires, with clusters in the place of the dim ones. A cell is made when a
// point in it is asked for the first time, and is a pure function of its box, so that the answers
// do not depend on who comes first. By trial it also knows what light is seen from it: its outlook.
#pragma once

#include "base/random.h"
#include "lighting/light_cut.h"
#include "lighting/light_query.h"
#include "lighting/settings.h"

#include <atomic>
#include <memory>

namespace candelabra {

class BuiltCutOctree {
public:
    /// What luminaires give at one point: for several choices and questions there.
    struct Weights : CutWeights {
        const LightCut* cut = nullptr;
        LightGuide::Weights outlook;  ///< when the scene was there to be asked
        double by_direction = 0;      ///< share of the shadow rays that should be drawn from it
        bool as_scattered = false;  ///< all shadow rays should go where the surface scatters light
        /// Standard deviation that one shadow ray's irradiance is expected to have; below 0: not
        /// known.
        double noise = -1;
        double irradiance = 0;  ///< that is expected; known where the noise is
    };

    class At;

    BuiltCutOctree(const LightOctree&, const LightScene&);
    BuiltCutOctree(BuiltCutOctree&&) noexcept;
    BuiltCutOctree& operator=(BuiltCutOctree&&) noexcept;
    ~BuiltCutOctree();

    At at(const LightQuery&) const;

    /// Precondition: the scene is there to be asked.
    void weigh(const LightQuery&, Weights&) const;
    /// The same without the scene: luminaires can be chosen by it, directions cannot be drawn.
    void weigh_choice(const Receiver&, const BsdfLobes&, Weights&) const;
    /// Appends the luminaire for u in [0, 1), if any is above the horizon.
    void choose(const Receiver&, const Weights&, const Key&, double u, LightPicks&) const;
    double expected(const Receiver&, const Weights&, LightIndex) const;

    void choose(const Receiver&, const Key&, LightPicks&) const;
    double expected(const Receiver&, const Key&, LightIndex) const;

    /// With the cells that there are so far.
    std::size_t memory_bytes() const;
    std::size_t cells() const;
    const LightTree& tree() const;

private:
    struct CellSurvey;
    struct Cell;
    struct State;

    Cell* cell_in(std::atomic<Cell*>&, const Box&, const Cell& parent, const LightProbe*) const;
    const Cell& cell_at(const Receiver&, const LightProbe*) const;
    std::unique_ptr<Cell> make(const Box&, const Cell& parent, const LightProbe*) const;
    CellSurvey survey(const Cell&, LightCut&, const LightProbe&) const;
    std::vector<float> counted(std::span<const float> shares, const LightCut&, const Box&) const;
    /// What shadow rays to chosen luminaires found: variance over squared mean, and the mean
    /// irradiance for each unit of the total weight.
    struct Found {
        double noise, irradiance;
    };
    Found found_by_choice(const LightCut&, std::span<const SurveyPlace>, const LightProbe&) const;
    std::uint32_t descend(const Receiver&, LightCluster, const Key&, double u,
                          double& probability) const;

    std::unique_ptr<State> state_;
};

/// At one receiver. A shadow ray has a direction from the cell's outlook, or as the surface
/// scatters light, in which whatever luminaire is seen counts, or a luminaire and a point on it:
/// weighed by the density that all ways together have for a point of a luminaire (one-sample
/// multiple importance sampling). So a luminaire that the outlook does not know keeps its chance,
/// no ray is lost where luminaires hide each other, and none glares that only a highlight shows.
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
    /// Shares of the shadow rays.
    double by_surface_ = 0, by_outlook_ = 0, by_choice_ = 1;
};

inline BuiltCutOctree::At BuiltCutOctree::at(const LightQuery& query) const {
    return {*this, query};
}

}  // namespace candelabra
