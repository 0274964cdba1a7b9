// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/operations.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

/// The points of a surface. Each of them that an operation reads or makes is counted as work:
/// operations read points for all that they do.
class CountedPoints {
public:
    using key_type = ExactSurface::Vertex_index;
    using value_type = ExactKernel::Point_3;
    using reference = const value_type&;
    using category = boost::read_write_property_map_tag;

    CountedPoints() = default;
    CountedPoints(ExactSurface& surface, WorkCount count)
        : points_(surface.points()), count_(count) {}

    friend reference get(const CountedPoints& map, key_type corner) {
        map.count_(reading);
        return map.points_[corner];
    }
    friend void put(const CountedPoints& map, key_type corner, const value_type& point) {
        map.count_(making);
        map.points_[corner] = point;
    }

private:
    static constexpr std::uint64_t reading = 2, making = 200;

    ExactSurface::Property_map<key_type, value_type> points_;
    WorkCount count_ = nullptr;
};

auto counted(ExactSurface& surface, WorkCount count) {
    return CGAL::parameters::vertex_point_map(CountedPoints(surface, count));
}

/// Orients the surface outwards; a shell within a shell is a hollow, and one within a hollow is
/// solid again. Returns the reason why it does not bound a solid; empty when it does.
std::string made_solid(ExactSurface& surface, WorkCount count) {
    const auto points = counted(surface, count);
    if (!CGAL::is_closed(surface)) return "it is not closed";
    for (const auto face : surface.faces())
        if (processing::is_degenerate_triangle_face(face, surface, points))
            return "the corners of a face lie on one line";
    if (processing::does_self_intersect(surface, points))
        return "its faces cut or touch each other";
    processing::orient_to_bound_a_volume(surface, points);
    return processing::does_bound_a_volume(surface, points)
               ? ""
               : "its shells do not lie in one another";
}

/// The surface of a solid, or the reason why there is none. CGAL's operations demand all this of
/// what they combine, and do not check it.
std::string make_solid(const Polyhedron& from, WorkCount count, ExactSurface& made) {
    constexpr std::uint64_t work_of_face = 100;
    count(work_of_face * from.faces.size());
    std::string wrong = polyhedra::unfit(from);
    if (!wrong.empty()) return wrong;
    const polyhedra::Soup soup = polyhedra::soup(from);
    wrong = wrong_faces(soup);
    if (!wrong.empty()) return wrong;
    made = polyhedra::connected<ExactSurface>(soup);
    return made_solid(made, count);
}

/// A surface without faces bounds nothing.
bool empty(const ExactSurface& surface) { return surface.number_of_faces() == 0; }

bool combined(SolidOperation operation, ExactSurface& a, ExactSurface& b, WorkCount count,
              ExactSurface& made) {
    if (empty(a) || empty(b)) {
        const bool other = empty(a) && operation == SolidOperation::join;
        if (other || operation != SolidOperation::intersect) made = other ? b : a;
        return true;
    }
    const auto points_a = counted(a, count), points_b = counted(b, count),
               points_made = counted(made, count);
    switch (operation) {
        case SolidOperation::join:
            return processing::corefine_and_compute_union(a, b, made, points_a, points_b,
                                                          points_made);
        case SolidOperation::intersect:
            return processing::corefine_and_compute_intersection(a, b, made, points_a, points_b,
                                                                 points_made);
        case SolidOperation::subtract:
            return processing::corefine_and_compute_difference(a, b, made, points_a, points_b,
                                                               points_made);
        case SolidOperation::take:
            break;
    }
    return false;
}

}  // namespace

std::string polyhedra::combine(std::span<const SolidOperation> steps,
                               std::span<const Polyhedron> solids, WorkCount count,
                               Polyhedron& made) {
    std::vector<ExactSurface> stack;
    std::size_t taken = 0;
    for (const SolidOperation step : steps) {
        if (step == SolidOperation::take) {
            const std::string wrong = make_solid(solids[taken++], count, stack.emplace_back());
            if (!wrong.empty())
                return "surface " + std::to_string(taken) + " bounds no solid: " + wrong;
            continue;
        }
        ExactSurface last = std::move(stack.back()), result;
        stack.pop_back();
        if (!combined(step, stack.back(), last, count, result))
            return "with surface " + std::to_string(taken) +
                   " the result would touch itself in an edge or a point";
        stack.back() = std::move(result);
    }
    if (empty(stack.back())) return "nothing is left";
    made = polyhedron(stack.back());
    return {};
}

}  // namespace candelabra
