// SPDX-License-Identifier: GPL-3.0-or-later
// An octree over the points to be lit, whose cells hold cuts through the light tree: the paper's
// lists of bright luminaires, with clusters in the place of the dim ones. A cell is made when a
// point in it is asked for the first time, and is a pure function of its box, so that the answers
// do not depend on who comes first. By trial it also knows what light is seen from it: its outlook.
#pragma once

#include "base/random.h"
#include "lighting/light_cut.h"
#include "lighting/outlook.h"
#include "lighting/settings.h"

#include <atomic>
#include <memory>

class BuiltCutOctree {
public:
    /// What luminaires give at one point: for several choices and questions there.
    struct Weights : CutWeights {
        const LightCut* cut = nullptr;
        Outlook::Weights outlook;   ///< when the scene was there to be asked
        double by_direction = 0;    ///< share of the shadow rays that should be drawn from it
        bool as_scattered = false;  ///< all shadow rays should go where the surface scatters light
        /// Standard deviation that one shadow ray's irradiance is expected to have; below 0: not
        /// known.
        double noise = -1;
        double irradiance = 0;  ///< that is expected; known where the noise is
    };

    BuiltCutOctree(const LightOctree&, const LightScene&);
    BuiltCutOctree(BuiltCutOctree&&) noexcept;
    BuiltCutOctree& operator=(BuiltCutOctree&&) noexcept;
    ~BuiltCutOctree();

    void weigh(const ShadingPoint&, const LightProbe&, const Gloss&, Weights&) const;
    /// The same without the scene: luminaires can be chosen by it, directions cannot be drawn.
    void weigh_choice(const ShadingPoint&, const Gloss&, Weights&) const;
    /// Appends the luminaire for u in [0, 1), if any is above the horizon.
    void choose(const ShadingPoint&, const Weights&, const Key&, double u, LightPicks&) const;
    double expected(const ShadingPoint&, const Weights&, LightIndex) const;

    void choose(const ShadingPoint&, const Key&, LightPicks&) const;
    double expected(const ShadingPoint&, const Key&, LightIndex) const;

    /// With the cells that there are so far.
    std::size_t memory_bytes() const;
    std::size_t cells() const;
    const LightTree& tree() const;

private:
    struct Survey;
    struct Cell;
    struct State;

    Cell* cell_in(std::atomic<Cell*>&, const Box&, const Cell* parent, const LightProbe*) const;
    const Cell& cell_at(const Vec3&, const LightProbe*) const;
    std::unique_ptr<Cell> make(const Box&, const Cell* parent, const LightProbe*) const;
    Survey survey(const Box&, LightCut&, const LightProbe&) const;
    std::vector<float> counted(std::span<const float> shares, const LightCut&, const Box&) const;
    double noise_of_choice(const LightCut&, std::span<const Receiver>, const LightProbe&) const;
    std::uint32_t descend(const ShadingPoint&, LightCluster, const Key&, double u,
                          double& probability) const;

    std::unique_ptr<State> state_;
};
