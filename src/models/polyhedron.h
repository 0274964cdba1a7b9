// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles as files of models have them, and as CGAL takes them: plain lists of points and faces.
#pragma once

#include <array>
#include <vector>

namespace candelabra {

/// Triangles over shared points. Faces are indices of points, counted from 0, counterclockwise as
/// seen from outside (in a right-handed space).
struct Polyhedron {
    using Point = std::array<double, 3>;
    using Face = std::array<int, 3>;

    std::vector<Point> points;
    std::vector<Face> faces;
};

/// Optional data of a file beyond the shape. Without faces of their own, normals and texture
/// coordinates are those of the points.
struct PolyhedronLook {
    std::vector<Polyhedron::Point> normals;
    std::vector<Polyhedron::Face> normal_faces;
    std::vector<std::array<double, 2>> uvs;
    std::vector<Polyhedron::Face> uv_faces;
    bool materials = false;  ///< faces have materials, which are not read
};

}  // namespace candelabra
