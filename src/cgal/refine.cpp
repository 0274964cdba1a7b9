// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/elementary.h"
#include "cgal/operations.h"

#include <CGAL/subdivision_method_3.h>

#include <utility>

namespace candelabra {

namespace {

// CGAL's rules take the cosine of the C library, whose last bits depend on the machine. These take
// ours, for the points of the given surface; new points have rational weights.

using polyhedra::Surface;
using Point = polyhedra::Kernel::Point_3;

double cosine_of_turn_by(double count) { return math::cos(2 * CGAL_PI / count); }

/// The points around one, and how many they are.
struct Ring {
    Ring(Surface::Vertex_index centre, const Surface& surface) {
        for (const auto v : CGAL::vertices_around_target(surface.halfedge(centre), surface)) {
            sum = sum + (surface.point(v) - CGAL::ORIGIN);
            ++count;
        }
    }

    polyhedra::Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
    double count = 0;
};

/// The point moved towards the mean of those around it by a share of the way.
Point moved(const Point& from, const Ring& around, double share) {
    return from + share * (CGAL::ORIGIN + around.sum / around.count - from);
}

struct LoopRule : CGAL::Loop_mask_3<Surface> {
    explicit LoopRule(Surface& mesh) : Loop_mask_3(&mesh, mesh.points()) {}

    void vertex_node(Surface::Vertex_index vertex, Point& made) {
        const Ring around(vertex, *pmesh);
        const double edge = 3 + 2 * cosine_of_turn_by(around.count);
        made = moved(pmesh->point(vertex), around, (40 - edge * edge) / 64);
    }
};

struct Root3Rule : CGAL::Sqrt3_mask_3<Surface> {
    explicit Root3Rule(Surface& mesh) : Sqrt3_mask_3(&mesh, mesh.points()) {}

    void vertex_node(Surface::Vertex_index vertex, Point& made) {
        const Ring around(vertex, *pmesh);
        made = moved(pmesh->point(vertex), around, (4 - 2 * cosine_of_turn_by(around.count)) / 9);
    }
};

}  // namespace

std::string polyhedra::subdivide(const Polyhedron& from, SubdivisionRule rule, int steps,
                                 Polyhedron& made) {
    const std::string wrong = unfit(from);
    if (!wrong.empty()) return wrong;
    Surface mesh = connected<Surface>(soup(from));
    if (mesh.number_of_faces() == 0) return "the surface has no faces";
    const auto count = CGAL::parameters::number_of_iterations(static_cast<unsigned>(steps));
    if (rule == SubdivisionRule::loop)
        CGAL::Subdivision_method_3::PTQ(mesh, LoopRule(mesh), count);
    else
        CGAL::Subdivision_method_3::Sqrt3(mesh, Root3Rule(mesh), count);
    Polyhedron finer = polyhedron(mesh);
    if (!not_finite(finer.points).empty()) return "its points lie too far out";
    made = std::move(finer);
    return {};
}

}  // namespace candelabra
