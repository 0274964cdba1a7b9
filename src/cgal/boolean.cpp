// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/operations.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <cstddef>
#include <utility>

namespace candelabra {

namespace {

namespace processing = CGAL::Polygon_mesh_processing;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactSurface = CGAL::Surface_mesh<ExactKernel::Point_3>;

/// Orients the surface outwards. Returns the reason why it does not bound a solid; empty when it
/// does.
std::string made_solid(ExactSurface& surface) {
    if (surface.number_of_faces() == 0) return "it has no faces";
    if (!CGAL::is_closed(surface)) return "it is not closed";
    if (processing::does_self_intersect(surface)) return "its faces cut each other";
    processing::orient_to_bound_a_volume(surface);
    return {};
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
    for (std::size_t i = 0; i < solids.size(); ++i)
        if (const std::string wrong = unfit(solids[i]); !wrong.empty())
            return "surface " + std::to_string(i + 1) + " bounds no solid: " + wrong;
    std::vector<ExactSurface> stack;
    std::size_t taken = 0;
    for (const SolidOperation step : steps) {
        if (step == SolidOperation::take) {
            stack.push_back(surface<ExactSurface>(solids[taken++]));
            const std::string wrong = made_solid(stack.back());
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
