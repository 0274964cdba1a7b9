// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/mesh_area.h"

#include "shape/area.h"

namespace candelabra {

MeshArea::MeshArea(const Mesh& mesh, std::span<const double> worth) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = face(mesh, i).corners;
        sum += surface_area(Triangle{a, b, c}) * (worth.empty() ? 1 : worth[i]);
        sums_.push_back(sum);
    }
}

DrawnShare MeshArea::at(double share) const {
    return drawn_share(std::span<const double>(sums_), share);
}

}  // namespace candelabra
