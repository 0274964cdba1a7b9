// SPDX-License-Identifier: GPL-3.0-or-later
// A short partition of all luminaires for the points of one cell: single luminaires where they
// matter, clusters of the light tree elsewhere. At a point all entries are weighed in one loop of
// single precision. Each entry above the horizon has a weight above 0, so every luminaire has a
// chance.
#pragma once

#include "lighting/bsdf_lobes.h"
#include "lighting/refined_cut.h"

namespace candelabra {

/// Unoccluded contributions of a cut's entries at a point.
struct CutWeights {
    static constexpr std::size_t most = 256;
    static constexpr std::size_t block = 16;
    std::array<float, most> weight;
    std::array<double, most / block> block_sum;
    double total = 0;
};

class LightCut {
public:
    /// A pure function of its arguments.
    LightCut(const LightTree&, const ChoosableLights&, const Box& cell, const CutRule&);

    /// Expected variance of the choice over the squared mean, by a rough bound, without single
    /// luminaires that outshine all others.
    double noise() const { return noise_; }
    std::size_t entries() const { return clusters_.size(); }
    const LightCluster& cluster(std::size_t entry) const { return clusters_[entry]; }
    /// Returns the entry that contains the luminaire at this place of the tree.
    std::size_t entry_of(std::uint32_t place) const;

    void weigh(const Receiver&, CutWeights&) const;
    /// Unoccluded irradiance of an entry with weight 1, as luminance.
    double unit() const { return unit_; }
    /// Turns weights at a point into those of the light that a glossy surface reflects to the
    /// viewer.
    void weigh_answers(const Receiver&, const BsdfLobes&, CutWeights&) const;
    /// Whether some entries have a falloff, and others fall off with the square of the distance.
    bool has_both_laws() const { return first_source_ > 0 && has_sources(); }
    /// Fraction of the total that entries with a falloff have. Precondition: the total is above 0.
    double share_of_sources(const CutWeights&) const;
    /// Multiplies the weights of the entries without a falloff by a factor.
    void dim_luminaires(double factor, CutWeights&) const;
    /// Adds a share of the total to the weights, evenly to all entries that have any.
    void share_evenly(double share, CutWeights&) const;
    /// Multiplies the weight of each entry by a factor above 0.
    void scale(std::span<const float> factors);
    /// Returns the entry at which the running sum of the weights passes target, which is in [0,
    /// total). The remainder is stored in target. Precondition: the total is above 0.
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
        bent_length,  ///< length of the bent normal
        columns,
        /// For lights with a falloff only, after the others: see FalloffTerms.
        fade_power = columns,
        per_fade_distance,
        cone_x,
        cone_y,
        cone_z,
        dark,
        per_edge,
        source_columns
    };

    struct Rough;
    Rough rough(const Receiver&) const;
    double light_in_cell(const LightProxy&, bool by_square_law) const;
    bool has_sources() const { return first_source_ < entries(); }
    /// `nearer`: factor on the entry's distance and size.
    void fill(std::size_t entry, const LightProxy&, double nearer);
    void fill(std::size_t entry, const Falloff&, double nearer);
    float* column(Column c) { return values_.data() + c * rows_; }
    const float* column(Column c) const { return values_.data() + c * rows_; }

    // All lengths are in units of the cell's size: what single precision rounds off is small as
    // seen from the cell, at any scale of the scene.
    Vec3 middle_;
    double scale_ = 1;
    std::size_t rows_ = 0;
    bool turned_ = false;  ///< whether any entry is flat, or has a bent normal
    /// The first entry with a falloff; those before it fall off with the square of the distance.
    std::size_t first_source_ = 0;
    double noise_ = 0;
    double unit_ = 1;
    std::vector<LightCluster> clusters_;  ///< in the tree's order
    std::vector<float> values_;           ///< column by column
};

}  // namespace candelabra
