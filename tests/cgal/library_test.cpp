// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/shapes.h"

namespace candelabra {

TEST_CASE("every entry of the library of polyhedra is there", "[polyhedra]") {
    const Polyhedra& library = the_polyhedra();
    CHECK(library.hull);
    CHECK(library.combine);
    CHECK(library.subdivide);
    CHECK(library.triangulate);
}

}  // namespace candelabra
