// SPDX-License-Identifier: GPL-3.0-or-later
// The luminaires that are not in a list, sampled uniformly or by their strength. Used by the
// paper's octree, whose cells list the bright luminaires.
#pragma once

#include "base/weighted_index.h"
#include "lighting/pick.h"

namespace candelabra {

/// The luminaires that remain when those of a list, in ascending order, are removed. Refers to its
/// arguments.
class DimSet {
public:
    /// dim_before[j] is the number of dim places before the j-th luminaire of the list: see
    /// dim_places_before().
    DimSet(const WeightedIndex& places, std::span<const LightIndex> bright,
           std::span<const std::uint64_t> dim_before)
        : places_(places), bright_(bright), dim_before_(dim_before) {}

    std::size_t lights() const { return places_.size() - bright_.size(); }
    /// Returns the dim luminaire with n others before it. Precondition: n < lights().
    LightIndex nth(std::uint64_t n) const;

    std::uint64_t places() const;
    /// Returns the dim luminaire at this place, counted without the bright ones. Precondition:
    /// place < places().
    LightIndex at(std::uint64_t place) const;

private:
    const WeightedIndex& places_;
    std::span<const LightIndex> bright_;
    std::span<const std::uint64_t> dim_before_;
};

/// For each luminaire of a list in ascending order, returns the number of places before it that
/// belong to luminaires not in the list.
std::vector<std::uint64_t> dim_places_before(const WeightedIndex&,
                                             std::span<const LightIndex> bright);

}  // namespace candelabra
