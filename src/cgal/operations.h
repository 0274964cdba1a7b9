// SPDX-License-Identifier: GPL-3.0-or-later
// The operations behind the table of polyhedra.h, and the surfaces that they work on. Private to
// this module.
#pragma once

#include "cgal/polyhedra.h"
#include "models/fan.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <map>
#include <stdexcept>

namespace candelabra {

namespace polyhedra {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

std::string hull(std::span<const Polyhedron::Point>, Polyhedron&);
std::string combine(std::span<const SolidOperation>, std::span<const Polyhedron>, WorkCount,
                    Polyhedron&);
std::string subdivide(const Polyhedron&, SubdivisionRule, int steps, Polyhedron&);
std::string triangulate(std::span<const std::array<double, 2>>, std::vector<Polyhedron::Face>&);

/// Reason why an operation cannot work on the polyhedron at all; empty when there is none. CGAL
/// does not check its input.
inline std::string unfit(const Polyhedron& given) {
    const std::string wrong = not_finite(given.points);
    return wrong.empty() ? wrong_place(given.faces, given.points.size(), "a point") : wrong;
}

/// Faces over points of which no two coincide, each with three corners that are apart.
struct Soup {
    std::vector<Polyhedron::Point> points;
    std::vector<std::array<std::size_t, 3>> faces;
};

/// Merges coincident points and drops faces with two corners at one point, so that a closed surface
/// stays closed. Points without a face are dropped. Precondition: unfit() is empty.
inline Soup soup(const Polyhedron& from) {
    const auto at = [&](int corner) { return from.points[static_cast<std::size_t>(corner)]; };
    std::vector<Polyhedron::Face> kept;
    std::vector<char> used(from.points.size());
    for (const auto& [a, b, c] : from.faces) {
        if (at(a) == at(b) || at(b) == at(c) || at(c) == at(a)) continue;
        kept.push_back({a, b, c});
        for (const int corner : {a, b, c}) used[static_cast<std::size_t>(corner)] = 1;
    }
    Soup made;
    std::map<Polyhedron::Point, std::size_t> places;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i] && places.try_emplace(from.points[i], made.points.size()).second)
            made.points.push_back(from.points[i]);
    for (const auto& [a, b, c] : kept)
        made.faces.push_back({places.at(at(a)), places.at(at(b)), places.at(at(c))});
    return made;
}

/// A surface with connectivity, whose faces are turned alike; where more than two faces meet in an
/// edge, points are duplicated. Throws where faces cannot be connected.
template <class Mesh>
Mesh connected(const Soup& from) {
    std::vector<typename Mesh::Point> points;
    for (const auto& [x, y, z] : from.points) points.emplace_back(x, y, z);
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& face : from.faces) faces.emplace_back(face.begin(), face.end());
    namespace processing = CGAL::Polygon_mesh_processing;
    processing::orient_polygon_soup(points, faces);
    if (!processing::is_polygon_soup_a_polygon_mesh(faces))
        throw std::runtime_error("its faces do not make a surface");
    Mesh made;
    processing::polygon_soup_to_polygon_mesh(points, faces, made);
    return made;
}

/// The surface's triangles. Precondition: all its faces are triangles.
template <class Mesh>
Polyhedron polyhedron(const Mesh& mesh) {
    Polyhedron made;
    std::vector<int> places(mesh.num_vertices() + mesh.number_of_removed_vertices());
    for (const auto v : mesh.vertices()) {
        const auto& p = mesh.point(v);
        places[static_cast<std::size_t>(v)] = static_cast<int>(made.points.size());
        made.points.push_back(
            {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    for (const auto f : mesh.faces()) {
        Polyhedron::Face& face = made.faces.emplace_back();
        std::size_t i = 0;
        for (const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
            if (i < 3) face[i++] = places[static_cast<std::size_t>(v)];
    }
    return made;
}

}  // namespace polyhedra

}  // namespace candelabra
