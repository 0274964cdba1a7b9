// SPDX-License-Identifier: GPL-3.0-or-later
// A short partition of all luminaires for the points of one cell: single ones where they matter,
// clusters of the light tree where they do not. At a point all entries are weighed in one loop of
// single precision. Each entry above the horizon has a weight above 0, so every luminaire has a
// chance.
#pragma once

#include "lighting/bsdf_lobes.h"
#include "lighting/refined_cut.h"

namespace candelabra {

/// What the entries of a cut give at a point, as if nothing were between.
struct CutWeights {
    static constexpr std::size_t most = 256;
    static constexpr std::size_t block = 16;
    std::array<float, most> weight;
    std::array<double, most / block> block_sum;
    double total = 0;
};

class LightCut {
public:
    /// A pure function of its arguments. The unit is a length of about the size of the scene.
    LightCut(const LightTree&, std::span<const Luminaire>, const Box& cell, const CutRule&,
             double unit);

    /// Expected variance of the choice over the squared mean, by a rough bound; without single
    /// luminaires that outshine all others.
    double noise() const { return noise_; }
    std::size_t entries() const { return clusters_.size(); }
    const LightCluster& cluster(std::size_t entry) const { return clusters_[entry]; }
    /// The entry that has the luminaire at this place of the tree.
    std::size_t entry_of(std::uint32_t place) const;

    void weigh(const Receiver&, CutWeights&) const;
    /// Makes of weights at a point those of what a surface that shines sends to the viewer.
    void weigh_answers(const Receiver&, const BsdfLobes&, CutWeights&) const;
    /// Multiplies the weights of each entry by a number above 0.
    void scale(std::span<const float> factors);
    /// The entry at which the running sum of the weights passes target, which is in [0, total).
    /// What is left of the target goes back. Precondition: the total is above 0.
    std::size_t find(const CutWeights&, double& target) const;

    std::size_t memory_bytes() const;

private:
    enum Column {
        x,
        y,
        z,
        radius,
        half_x,
        half_y,
        half_z,
        strength,
        axis_x,
        axis_y,
        axis_z,
        evenness,
        bent_x,
        bent_y,
        bent_z,
        bent_length,  ///< its length
        columns,
        /// Of light sources only, behind the others.
        fade_power = columns,
        per_fade_distance,
        dark,      ///< cosine of the half angle of the cone; much below -1: there is none
        per_edge,  ///< one over the cosine of the bright part less that
        source_columns
    };

    struct Rough;
    Rough rough(const Receiver&) const;
    void fill(std::size_t entry, const LightProxy&);
    void fill(std::size_t entry, const Falloff&);
    float* column(Column c) { return values_.data() + c * rows_; }
    const float* column(Column c) const { return values_.data() + c * rows_; }

    Vec3 middle_;
    double scale_ = 1;  ///< of lengths
    std::size_t rows_ = 0;
    bool turned_ = false;  ///< some are flat, or have a bent normal
    bool sources_ = false;
    double noise_ = 0;
    std::vector<LightCluster> clusters_;  ///< in the tree's order
    std::vector<float> values_;           ///< column by column
};

}  // namespace candelabra
