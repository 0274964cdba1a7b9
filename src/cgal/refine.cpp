// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/operations.h"

#include <CGAL/subdivision_method_3.h>

#include <utility>

namespace candelabra {

std::string polyhedra::subdivide(const Polyhedron& from, SubdivisionRule rule, int steps,
                                 Polyhedron& made) {
    const std::string wrong = unfit(from);
    if (!wrong.empty()) return wrong;
    Surface mesh = surface<Surface>(from);
    if (mesh.number_of_faces() == 0) return "the surface has no faces";
    const auto count = CGAL::parameters::number_of_iterations(static_cast<unsigned>(steps));
    if (rule == SubdivisionRule::loop)
        CGAL::Subdivision_method_3::Loop_subdivision(mesh, count);
    else
        CGAL::Subdivision_method_3::Sqrt3_subdivision(mesh, count);
    Polyhedron finer = polyhedron(mesh);
    if (!not_finite(finer.points).empty()) return "its points lie too far out";
    made = std::move(finer);
    return {};
}

}  // namespace candelabra
