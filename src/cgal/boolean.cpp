// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/operations.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace candelabra {

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactSurface = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// Reason why the faces bound no solid, however they are turned and wherever their points lie;
/// empty when there is none.
std::string wrong_faces(const polyhedra::Soup& soup) {
    if (soup.faces.empty()) return "it has no faces";
    std::set<std::array<std::size_t, 3>> known;
    std::map<std::pair<std::size_t, std::size_t>, int> edges;
    for (std::array<std::size_t, 3> face : soup.faces) {
        std::sort(face.begin(), face.end());
        if (!known.insert(face).second) return "two of its faces have the same corners";
        for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(face[i], face[(i + 1) % 3])];
    }
    int most = 0;
    for (const auto& [edge, faces] : edges) {
        if (faces == 1) return "it is not closed";
        most = std::max(most, faces);
    }
    return most > 2 ? "more than two of its faces meet in an edge" : "";
}

/// Orients the surface outwards; a shell within a shell is a hollow, and one within a hollow is
/// solid again. Returns the reason why it does not bound a solid; empty when it does.
std::string made_solid(ExactSurface& surface) {
    if (!CGAL::is_closed(surface)) return "it is not closed";
    for (const auto face : surface.faces())
        if (processing::is_degenerate_triangle_face(face, surface))
            return "the corners of a face lie on one line";
    if (processing::does_self_intersect(surface)) return "its faces cut or touch each other";
    processing::orient_to_bound_a_volume(surface);
    return processing::does_bound_a_volume(surface) ? "" : "its shells do not lie in one another";
}

/// The surface of a solid, or the reason why there is none. CGAL's operations demand all this of
/// what they combine, and do not check it.
std::string make_solid(const Polyhedron& from, ExactSurface& made) {
    std::string wrong = polyhedra::unfit(from);
    if (!wrong.empty()) return wrong;
    const polyhedra::Soup soup = polyhedra::soup(from);
    wrong = wrong_faces(soup);
    if (!wrong.empty()) return wrong;
    made = polyhedra::connected<ExactSurface>(soup);
    return made_solid(made);
}

/// A surface without faces bounds nothing.
bool empty(const ExactSurface& surface) { return surface.number_of_faces() == 0; }

bool combined(SolidOperation operation, ExactSurface& a, ExactSurface& b, ExactSurface& made) {
    if (empty(a) || empty(b)) {
        const bool other = empty(a) && operation == SolidOperation::join;
        if (other || operation != SolidOperation::intersect) made = other ? b : a;
        return true;
    }
    switch (operation) {
        case SolidOperation::join:
            return processing::corefine_and_compute_union(a, b, made);
        case SolidOperation::intersect:
            return processing::corefine_and_compute_intersection(a, b, made);
        case SolidOperation::subtract:
            return processing::corefine_and_compute_difference(a, b, made);
        case SolidOperation::take:
            break;
    }
    return false;
}

}  // namespace

std::string polyhedra::combine(std::span<const SolidOperation> steps,
                               std::span<const Polyhedron> solids, Polyhedron& made) {
    std::vector<ExactSurface> stack;
    std::size_t taken = 0;
    for (const SolidOperation step : steps) {
        if (step == SolidOperation::take) {
            const std::string wrong = make_solid(solids[taken++], stack.emplace_back());
            if (!wrong.empty())
                return "surface " + std::to_string(taken) + " bounds no solid: " + wrong;
            continue;
        }
        ExactSurface last = std::move(stack.back()), result;
        stack.pop_back();
        if (!combined(step, stack.back(), last, result))
            return "with surface " + std::to_string(taken) +
                   " the result would touch itself in an edge or a point";
        stack.back() = std::move(result);
    }
    if (empty(stack.back())) return "nothing is left";
    made = polyhedron(stack.back());
    return {};
}

}  // namespace candelabra
