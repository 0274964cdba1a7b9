// SPDX-License-Identifier: GPL-3.0-or-later
// Cumulative area of the faces of a mesh, for points distributed over it uniformly or by the
// weights of faces. Used for the proxy meshes of luminaires and where the language scatters points.
#pragma once

#include "base/running_sums.h"
#include "shape/mesh.h"

namespace candelabra {

class MeshArea {
public:
    /// `worth` is the weight of each face's area, 0 or more; empty: all weights are 1.
    explicit MeshArea(const Mesh&, std::span<const double> worth = {});

    double total() const { return sums_.empty() ? 0 : sums_.back(); }

    /// Returns the face at a fraction `share`, 0 to 1, of the cumulative area, and the remaining
    /// fraction of that face's own area. Precondition: the area is above 0.
    DrawnShare at(double share) const;

private:
    std::vector<double> sums_;  ///< of the areas up to and including each face
};

}  // namespace candelabra
