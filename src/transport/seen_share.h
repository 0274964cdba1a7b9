// SPDX-License-Identifier: GPL-3.0-or-later
// How much of what the camera sees the light of a place reaches: about the fraction of the seen
// places from which it is visible. Light that stays outside of a room must not be chosen in it.
#pragma once

#include "base/halved_space.h"
#include "base/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// A pure function of the trials from which it was made. Immutable.
class SeenShare {
public:
    struct Trial {
        Vec3 position, normal;
        double seen;  ///< fraction of the places tried
    };

    SeenShare() = default;  ///< all places count alike
    explicit SeenShare(std::span<const Trial>);

    /// Above 0, and at most 1.
    double at(const Vec3& position, const Vec3& normal) const;

private:
    /// For normals that lie nearest to each direction along an axis.
    std::array<HalvedSpace, 6> sides_;
};

}  // namespace candelabra
