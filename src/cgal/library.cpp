// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/operations.h"

#include <exception>

namespace candelabra {

namespace {

/// Wraps an operation so that an exception becomes its error.
template <auto operation>
struct Guarded;
template <class... Arguments, std::string (*operation)(Arguments...)>
struct Guarded<operation> {
    static std::string call(Arguments... arguments) {
        try {
            return operation(arguments...);
        } catch (const std::exception& problem) {
            return problem.what();
        }
    }
};

}  // namespace

extern "C" const Polyhedra* candelabra_polyhedra() {
    static constexpr Polyhedra entries{
        &Guarded<&polyhedra::hull>::call, &Guarded<&polyhedra::combine>::call,
        &Guarded<&polyhedra::subdivide>::call, &Guarded<&polyhedra::triangulate>::call};
    return &entries;
}

}  // namespace candelabra
