// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyhedra/operations.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <fstream>

namespace {

/// A face of many corners, cut along diagonals as they come from its first corner when it is
/// convex; modellers write no others but by mistake.
void add_face(const std::vector<std::size_t>& corners, std::vector<Polyhedron::Face>& faces) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        faces.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[i - 1]),
                         static_cast<int>(corners[i])});
}

}  // namespace

std::string polyhedra::read(const std::string& path, Polyhedron& made) {
    if (!std::ifstream(path)) return "the file cannot be opened";
    std::vector<Kernel::Point_3> points;
    std::vector<std::vector<std::size_t>> faces;
    if (!CGAL::IO::read_polygon_soup(path, points, faces, CGAL::parameters::verbose(false)))
        return "it is no OBJ, PLY, STL or OFF file, or is damaged";
    for (const auto& face : faces)
        for (const std::size_t corner : face)
            if (corner >= points.size())
                return "a face has corner " + std::to_string(corner) + " of " +
                       std::to_string(points.size());
    for (const auto& p : points) made.points.push_back({p.x(), p.y(), p.z()});
    for (const auto& face : faces) add_face(face, made.faces);
    return made.faces.empty() ? "it has no faces" : "";
}
