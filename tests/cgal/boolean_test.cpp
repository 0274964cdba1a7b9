// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/shapes.h"

namespace candelabra {

namespace {

/// Combines the parts from first to last.
std::string combine(SolidOperation operation, std::span<const Polyhedron> parts, Polyhedron& made) {
    std::vector<SolidOperation> steps = {SolidOperation::take};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        steps.push_back(SolidOperation::take);
        steps.push_back(operation);
    }
    return the_polyhedra().combine(steps, parts, made);
}

}  // namespace

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
        REQUIRE(combine(c.operation, std::span(parts).first(c.parts), made) == "");
        CHECK(volume(made) == Approx(c.volume));
    }
}

TEST_CASE("solids that only share a face are joined", "[polyhedra]") {
    const std::vector<Polyhedron> parts = {unit_cube(0, 0, 0), unit_cube(1, 0, 0)};
    Polyhedron made;
    REQUIRE(combine(SolidOperation::join, parts, made) == "");
    CHECK(volume(made) == Approx(2));
}

TEST_CASE("what bounds no solid is said", "[polyhedra]") {
    Polyhedron open = unit_cube(0, 0, 0), apart = unit_cube(5, 0, 0);
    const std::vector<Polyhedron> far = {unit_cube(0, 0, 0), apart};
    Polyhedron made;
    CHECK(combine(SolidOperation::intersect, far, made) == "nothing is left");
    open.faces.pop_back();
    const std::vector<Polyhedron> parts = {apart, open};
    CHECK(combine(SolidOperation::join, parts, made) ==
          "surface 2 bounds no solid: it is not closed");
}

TEST_CASE("nothing is combined with something as well", "[polyhedra]") {
    using enum SolidOperation;
    const std::vector<Polyhedron> parts = {unit_cube(0, 0, 0), unit_cube(5, 0, 0),
                                           unit_cube(2, 0, 0)};
    const auto volume_of = [&](std::vector<SolidOperation> steps) {
        Polyhedron made;
        const std::string wrong = the_polyhedra().combine(steps, parts, made);
        return wrong.empty() ? volume(made) : 0;
    };
    CHECK(volume_of({take, take, intersect, take, join}) == Approx(1));
    CHECK(volume_of({take, take, intersect, take, subtract}) == 0);
    CHECK(volume_of({take, take, take, intersect, subtract}) == Approx(1));
}

TEST_CASE("a surface stays closed where points come together", "[polyhedra]") {
    // A corner of the cube is duplicated, with faces of no area between both.
    Polyhedron cube = unit_cube(0, 0, 0);
    cube.points.push_back(cube.points[0]);
    for (Polyhedron::Face& face : cube.faces)
        if (face[0] == 0 && face[2] == 3) face[0] = 8;
    cube.faces.push_back({8, 0, 2});
    cube.faces.push_back({0, 8, 3});
    Polyhedron made;
    CHECK(the_polyhedra().combine(std::vector{SolidOperation::take}, std::vector{cube}, made) ==
          "");
}

}  // namespace candelabra
