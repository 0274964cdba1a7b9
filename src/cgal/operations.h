// SPDX-License-Identifier: GPL-3.0-or-later
// The operations behind the table of polyhedra.h, and the surfaces that they work on. Private to
// this module.
#pragma once

#include "cgal/fan.h"
#include "cgal/polyhedra.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string_view>

namespace candelabra {

namespace polyhedra {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

std::string read(std::string_view name, std::string_view bytes, Polyhedron&, PolyhedronLook&);
std::string hull(std::span<const Polyhedron::Point>, Polyhedron&);
std::string combine(std::span<const SolidOperation>, std::span<const Polyhedron>, Polyhedron&);
std::string subdivide(const Polyhedron&, SubdivisionRule, int steps, Polyhedron&);
std::string triangulate(std::span<const std::array<double, 2>>, std::vector<Polyhedron::Face>&);

/// Reason why an operation cannot work on the polyhedron at all; empty when there is none. CGAL
/// does not check its input.
inline std::string unfit(const Polyhedron& given) {
    const std::string wrong = not_finite(given.points);
    return wrong.empty() ? wrong_place(given.faces, given.points.size(), "a point") : wrong;
}

/// Converts the faces to a surface with connectivity; where more than two faces meet in an edge,
/// points are duplicated. Coincident points are merged, and faces with two corners at one point are
/// dropped, so that a closed surface stays closed. Points without a face are dropped. Precondition:
/// unfit() is empty. Throws where faces cannot be connected.
template <class Mesh>
Mesh surface(const Polyhedron& from) {
    using Point = typename Mesh::Point;
    const auto at = [&](int corner) { return from.points[static_cast<std::size_t>(corner)]; };
    std::vector<char> used(from.points.size());
    std::vector<Polyhedron::Face> kept;
    for (const auto& [a, b, c] : from.faces) {
        if (at(a) == at(b) || at(b) == at(c) || at(c) == at(a)) continue;
        kept.push_back({a, b, c});
        for (const int corner : {a, b, c}) used[static_cast<std::size_t>(corner)] = 1;
    }
    std::vector<Point> points;
    std::map<Polyhedron::Point, std::size_t> places;
    for (std::size_t i = 0; i < used.size(); ++i) {
        const auto& p = from.points[i];
        if (used[i] && places.try_emplace(p, points.size()).second)
            points.emplace_back(p[0], p[1], p[2]);
    }
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& [a, b, c] : kept)
        faces.push_back({places.at(at(a)), places.at(at(b)), places.at(at(c))});
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
