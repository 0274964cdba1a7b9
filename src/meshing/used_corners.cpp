// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/used_corners.h"

namespace candelabra {

Mesh with_used_corners(const Mesh& mesh) {
    constexpr int unused = -1;
    Mesh result;
    std::vector<int> places(mesh.vertices.size(), unused);
    for (Face face : mesh.faces) {
        for (int& corner : face) {
            const auto old = static_cast<std::size_t>(corner);
            if (places[old] == unused) {
                places[old] = static_cast<int>(result.vertices.size());
                result.vertices.push_back(mesh.vertices[old]);
            }
            corner = places[old];
        }
        result.faces.push_back(face);
    }
    return result;
}

}  // namespace candelabra
