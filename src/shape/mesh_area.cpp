// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/mesh_area.h"

#include "shape/area.h"

#include <algorithm>

MeshArea::MeshArea(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = face(mesh, i).corners;
        sums_.push_back(sum += surface_area(Triangle{a, b, c}));
    }
}

MeshArea::Place MeshArea::at(double share) const {
    const double wanted = share * total();
    const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, wanted);
    const auto face = static_cast<std::size_t>(found - sums_.begin());
    const double before = face == 0 ? 0 : sums_[face - 1];
    return {face, std::clamp((wanted - before) / (sums_[face] - before), 0.0, 1.0)};
}
