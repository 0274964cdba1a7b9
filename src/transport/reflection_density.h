// SPDX-License-Identifier: GPL-3.0-or-later
// How densely light paths leave reflected luminaires on the surfaces of a scene, from place to
// place.
#pragma once

#include "base/vector.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace candelabra {

/// A pure function of the positions from which it was made. Immutable.
class ReflectionDensity {
public:
    ReflectionDensity() = default;
    /// Of positions on surfaces; at least 2.
    explicit ReflectionDensity(std::vector<Vec3> positions);

    bool empty() const { return parts_.empty(); }
    /// Number of positions per unit of area about a place. Above 0 and finite. Precondition: not
    /// empty().
    double at(const Vec3&) const;

private:
    struct Part {
        double border = 0;         ///< between its halves
        std::uint32_t second = 0;  ///< the upper half, which the lower one precedes; 0: undivided
        std::int8_t axis = 0;
        double density = 0;
    };

    void divide(std::vector<Vec3>&, std::size_t first, std::size_t end, double greatest);

    std::vector<Part> parts_;  ///< depth first
};

}  // namespace candelabra
