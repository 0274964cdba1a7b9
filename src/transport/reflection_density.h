// SPDX-License-Identifier: GPL-3.0-or-later
// How densely light paths leave reflected luminaires on the surfaces of a scene, or in its media,
// from place to place.
#pragma once

#include "base/halved_space.h"
#include "base/vector.h"

#include <vector>

namespace candelabra {

/// A pure function of the positions from which it was made. Immutable.
class ReflectionDensity {
public:
    ReflectionDensity() = default;
    /// Of positions on surfaces; at least 2.
    explicit ReflectionDensity(std::vector<Vec3> positions);
    /// Of positions in media, per unit of volume; at least 2.
    static ReflectionDensity in_air(std::vector<Vec3> positions);

    bool empty() const { return space_.empty(); }
    /// Number of positions per unit of area about a place. Above 0 and finite. Precondition: not
    /// empty().
    double at(const Vec3& place) const { return space_.at(place); }

private:
    HalvedSpace space_;
};

}  // namespace candelabra
