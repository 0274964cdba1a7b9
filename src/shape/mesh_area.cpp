// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/mesh_area.h"

#include "shape/area.h"

MeshArea::MeshArea(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = face(mesh, i).corners;
        sums_.push_back(sum += surface_area(Triangle{a, b, c}));
    }
}

DrawnShare MeshArea::at(double share) const {
    return drawn_share(std::span<const double>(sums_), share);
}
