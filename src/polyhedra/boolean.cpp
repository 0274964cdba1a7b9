// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyhedra/operations.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactSurface = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// What keeps the surface from being a solid's; empty when nothing does. Turns it right side out.
std::string made_solid(ExactSurface& surface) {
    if (surface.number_of_faces() == 0) return "it has no faces";
    if (!CGAL::is_closed(surface)) return "it is not closed";
    if (processing::does_self_intersect(surface)) return "its faces cut each other";
    processing::orient_to_bound_a_volume(surface);
    return {};
}

bool combined(SolidOperation operation, ExactSurface& a, ExactSurface& b, ExactSurface& made) {
    switch (operation) {
        case SolidOperation::join:
            return processing::corefine_and_compute_union(a, b, made);
        case SolidOperation::intersect:
            return processing::corefine_and_compute_intersection(a, b, made);
        case SolidOperation::subtract:
            return processing::corefine_and_compute_difference(a, b, made);
    }
    return false;
}

}  // namespace

std::string polyhedra::combine(SolidOperation operation, std::span<const Polyhedron> parts,
                               Polyhedron& made) {
    ExactSurface whole;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        ExactSurface part = surface<ExactSurface>(parts[i]);
        const std::string wrong = made_solid(part);
        if (!wrong.empty())
            return "surface " + std::to_string(i + 1) + " bounds no solid: " + wrong;
        if (i == 0) {
            whole = std::move(part);
            continue;
        }
        ExactSurface result;
        if (!combined(operation, whole, part, result))
            return "with surface " + std::to_string(i + 1) +
                   " the result would touch itself in an edge or a point";
        whole = std::move(result);
    }
    if (whole.number_of_faces() == 0) return "nothing is left";
    made = polyhedron(whole);
    return {};
}
