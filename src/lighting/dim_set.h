// SPDX-License-Identifier: GPL-3.0-or-later
// The luminaires that are not in a list, sampled uniformly or by their strength. Counting is exact:
// strengths are integers, so rounding cannot lose a luminaire. Used by the light octree, whose
// cells list the bright luminaires.
#pragma once

#include "lighting/pick.h"

namespace candelabra {

/// All luminaires laid end to end. Each takes a number of places in proportion to its intensity: at
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
    /// Returns the luminaire that takes the place. Precondition: place < total().
    LightIndex at(std::uint64_t place) const;
    std::size_t memory_bytes() const;

private:
    std::vector<std::uint64_t> ends_;
    std::vector<LightIndex> guide_;  ///< first luminaire of each of equal parts of the places
    int guide_shift_ = 0;
};

/// The luminaires that remain when those of a list, in ascending order, are removed. Refers to its
/// arguments.
class DimSet {
public:
    /// dim_before[j] is the number of dim places before the j-th luminaire of the list: see
    /// dim_places_before().
    DimSet(const LightPlaces& places, std::span<const LightIndex> bright,
           std::span<const std::uint64_t> dim_before)
        : places_(places), bright_(bright), dim_before_(dim_before) {}

    std::size_t lights() const { return places_.lights() - bright_.size(); }
    /// Returns the dim luminaire with n others before it. Precondition: n < lights().
    LightIndex nth(std::uint64_t n) const;

    std::uint64_t places() const;
    /// Returns the dim luminaire at this place, counted without the bright ones. Precondition:
    /// place < places().
    LightIndex at(std::uint64_t place) const;

private:
    const LightPlaces& places_;
    std::span<const LightIndex> bright_;
    std::span<const std::uint64_t> dim_before_;
};

/// For each luminaire of a list in ascending order, returns the number of places before it that
/// belong to luminaires not in the list.
std::vector<std::uint64_t> dim_places_before(const LightPlaces&,
                                             std::span<const LightIndex> bright);

}  // namespace candelabra
