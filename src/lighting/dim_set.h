// SPDX-License-Identifier: GPL-3.0-or-later
// The luminaires that are not in a list, drawn evenly or by their strength. Counting is exact:
// strengths are integers, so no luminaire can get lost in rounding. Used by the light octree, whose
// cells list the bright luminaires.
#pragma once

#include "lighting/pick.h"

namespace candelabra {

/// All luminaires laid end to end, each on a number of places in proportion to its intensity: at
/// least one, unless it is dark.
class LightPlaces {
public:
    LightPlaces() = default;
    explicit LightPlaces(std::span<const double> intensities);

    std::size_t lights() const { return ends_.size(); }
    std::uint64_t total() const { return ends_.empty() ? 0 : ends_.back(); }
    std::uint64_t before(LightIndex light) const { return light == 0 ? 0 : ends_[light - 1]; }
    std::uint64_t end(LightIndex light) const { return ends_[light]; }
    std::uint64_t of(LightIndex light) const { return end(light) - before(light); }
    /// Whose place it is. Precondition: place < total().
    LightIndex at(std::uint64_t place) const;
    std::size_t memory_bytes() const;

private:
    std::vector<std::uint64_t> ends_;
    std::vector<LightIndex> guide_;  ///< first luminaire of each of equal parts of the places
    int guide_shift_ = 0;
};

/// What is left when the luminaires of a list, in ascending order, are taken out. Refers to its
/// arguments.
class DimSet {
public:
    /// dim_before[j] is the number of dim places before the j-th luminaire of the list: see
    /// dim_places_before().
    DimSet(const LightPlaces& places, std::span<const LightIndex> bright,
           std::span<const std::uint64_t> dim_before)
        : places_(places), bright_(bright), dim_before_(dim_before) {}

    std::size_t lights() const { return places_.lights() - bright_.size(); }
    /// The dim luminaire that has n others before it. Precondition: n < lights().
    LightIndex nth(std::uint64_t n) const;

    std::uint64_t places() const;
    /// The dim luminaire that has this place, counted without the bright ones. Precondition: place
    /// < places().
    LightIndex at(std::uint64_t place) const;

private:
    const LightPlaces& places_;
    std::span<const LightIndex> bright_;
    std::span<const std::uint64_t> dim_before_;
};

/// Per luminaire of a list in ascending order, the places of those before it that are not in the
/// list.
std::vector<std::uint64_t> dim_places_before(const LightPlaces&,
                                             std::span<const LightIndex> bright);

}  // namespace candelabra
