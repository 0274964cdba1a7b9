// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyhedra/shapes.h"

TEST_CASE("subdivision divides every face and rounds what it divides", "[polyhedra]") {
    struct Case {
        SubdivisionRule rule;
        int steps;
        std::size_t faces;
    };
    const Case cases[] = {{SubdivisionRule::loop, 1, 48},
                          {SubdivisionRule::loop, 2, 192},
                          {SubdivisionRule::root3, 1, 36},
                          {SubdivisionRule::root3, 2, 108}};
    for (const Case& c : cases) {
        Polyhedron made;
        REQUIRE(the_polyhedra().subdivide(unit_cube(0, 0, 0), c.rule, c.steps, made) == "");
        CHECK(made.faces.size() == c.faces);
        CHECK(volume(made) < 0.95);
        CHECK(volume(made) > 0.3);
    }
    Polyhedron made;
    CHECK(the_polyhedra().subdivide({}, SubdivisionRule::loop, 1, made) ==
          "the surface has no faces");
}
