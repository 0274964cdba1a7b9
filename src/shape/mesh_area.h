// SPDX-License-Identifier: GPL-3.0-or-later
// The area of a mesh, face after face: for points that are spread over it, evenly or as much as
// each face is worth. Called for the guides of luminaires and where the language scatters points.
#pragma once

#include "base/running_sums.h"
#include "shape/mesh.h"

namespace candelabra {

class MeshArea {
public:
    /// `worth`: how much each face's area counts, 0 or more; none: 1 of all.
    explicit MeshArea(const Mesh&, std::span<const double> worth = {});

    double total() const { return sums_.empty() ? 0 : sums_.back(); }

    /// The face where so much of the area, 0 to 1, lies behind, and the same of its own area.
    /// Precondition: the area is above 0.
    DrawnShare at(double share) const;

private:
    std::vector<double> sums_;  ///< of each face and those before it
};

}  // namespace candelabra
