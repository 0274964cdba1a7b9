// SPDX-License-Identifier: GPL-3.0-or-later
// The luminaires that are not in a list, drawn by weight. Counting is exact: weights are integers, so no luminaire can get
// lost in rounding. Used by the light octree, whose cells list the bright luminaires.
#pragma once

#include "lighting/pick.h"

/// All luminaires with a weight for each, laid end to end: light i has the places [before(i), before(i) + weight(i)).
class LightWeights {
public:
    LightWeights() = default;
    /// Most of the weight goes by intensity, a part is shared evenly: a faint luminaire may still be the nearest.
    explicit LightWeights(std::span<const double> intensities);

    std::uint64_t total() const { return ends_.empty() ? 0 : ends_.back(); }
    std::uint64_t before(LightIndex light) const { return light == 0 ? 0 : ends_[light - 1]; }
    std::uint64_t weight(LightIndex light) const { return ends_[light] - before(light); }
    /// The luminaire that has this place, which is below total().
    LightIndex at(std::uint64_t place) const;
    std::size_t memory_bytes() const;

private:
    std::vector<std::uint64_t> ends_;
    std::vector<LightIndex> guide_;  ///< first luminaire of each of equal parts of the places
    int guide_shift_ = 0;
};

/// What is left when the luminaires of a list are taken out. Refers to the list.
class DimSet {
public:
    /// places[j] is the weight of the dim luminaires before the j-th of the list: see dim_places().
    DimSet(const LightWeights& weights, std::span<const LightIndex> bright, std::span<const std::uint64_t> places)
        : weights_(weights), bright_(bright), places_(places) {}

    std::uint64_t total() const;
    /// The dim luminaire that has this place, which is below total().
    LightIndex at(std::uint64_t place) const;

private:
    const LightWeights& weights_;
    std::span<const LightIndex> bright_;
    std::span<const std::uint64_t> places_;
};

/// Per luminaire of a list in ascending order, the weight of those before it that are not in the list.
std::vector<std::uint64_t> dim_places(const LightWeights&, std::span<const LightIndex> bright);
