// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyhedra/shapes.h"

TEST_CASE("solids are joined, intersected and subtracted exactly", "[polyhedra]") {
    const std::vector<Polyhedron> parts = {unit_cube(0, 0, 0), unit_cube(0.5, 0.5, 0.5),
                                           unit_cube(-0.75, 0, 0.25)};
    struct Case {
        SolidOperation operation;
        std::size_t parts;
        double volume;
    };
    const Case cases[] = {{SolidOperation::join, 2, 2 - 0.125},
                          {SolidOperation::intersect, 2, 0.125},
                          {SolidOperation::subtract, 2, 1 - 0.125},
                          {SolidOperation::subtract, 3, 1 - 0.125 - 0.25 * 0.75},
                          {SolidOperation::join, 1, 1}};
    for (const Case& c : cases) {
        Polyhedron made;
        REQUIRE(the_polyhedra().combine(c.operation, std::span(parts).first(c.parts), made) == "");
        CHECK(volume(made) == Approx(c.volume));
    }
}

TEST_CASE("solids that only share a face are joined", "[polyhedra]") {
    const std::vector<Polyhedron> parts = {unit_cube(0, 0, 0), unit_cube(1, 0, 0)};
    Polyhedron made;
    REQUIRE(the_polyhedra().combine(SolidOperation::join, parts, made) == "");
    CHECK(volume(made) == Approx(2));
}

TEST_CASE("what bounds no solid is said", "[polyhedra]") {
    Polyhedron open = unit_cube(0, 0, 0), apart = unit_cube(5, 0, 0);
    const std::vector<Polyhedron> far = {unit_cube(0, 0, 0), apart};
    Polyhedron made;
    CHECK(the_polyhedra().combine(SolidOperation::intersect, far, made) == "nothing is left");
    open.faces.pop_back();
    const std::vector<Polyhedron> parts = {apart, open};
    CHECK(the_polyhedra().combine(SolidOperation::join, parts, made) ==
          "surface 2 bounds no solid: it is not closed");
}
