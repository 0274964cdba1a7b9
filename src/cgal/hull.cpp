// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/operations.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <utility>

namespace candelabra {

std::string polyhedra::hull(std::span<const Polyhedron::Point> points, Polyhedron& made) {
    const std::string wrong = not_finite(points);
    if (!wrong.empty()) return wrong;
    std::vector<Kernel::Point_3> all;
    all.reserve(points.size());
    for (const auto& [x, y, z] : points) all.emplace_back(x, y, z);
    Surface surface;
    if (all.size() > 3) CGAL::convex_hull_3(all.begin(), all.end(), surface);
    if (surface.number_of_faces() < 4 || !CGAL::is_closed(surface))
        return "the points lie in one plane";
    made = polyhedron(surface);
    return {};
}

std::string polyhedra::triangulate(std::span<const std::array<double, 2>> points,
                                   std::vector<Polyhedron::Face>& faces) {
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
    using Triangulation =
        CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
    const std::string wrong = not_finite(points);
    if (!wrong.empty()) return wrong;
    std::vector<std::pair<Kernel::Point_2, int>> all;
    all.reserve(points.size());
    for (const auto& [x, y] : points) all.emplace_back(Kernel::Point_2(x, y), all.size());
    const Triangulation made(all.begin(), all.end());
    for (const auto& face : made.finite_face_handles())
        faces.push_back(
            {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    std::sort(faces.begin(), faces.end());
    return faces.empty() ? "the points lie on one line" : "";
}

}  // namespace candelabra
