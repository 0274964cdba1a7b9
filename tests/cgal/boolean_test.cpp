// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/shapes.h"

#include <map>
#include <utility>

namespace candelabra {

namespace {

/// Combines the parts from first to last.
std::string combine(SolidOperation operation, std::span<const Polyhedron> parts, Polyhedron& made) {
    std::vector<SolidOperation> steps = {SolidOperation::take};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        steps.push_back(SolidOperation::take);
        steps.push_back(operation);
    }
    return the_polyhedra().combine(steps, parts, uncounted, made);
}

/// One surface of all the faces.
Polyhedron together(std::vector<Polyhedron> parts) {
    Polyhedron all;
    for (const Polyhedron& part : parts) {
        const int first = static_cast<int>(all.points.size());
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        for (const auto& [a, b, c] : part.faces)
            all.faces.push_back({a + first, b + first, c + first});
    }
    return all;
}

Polyhedron inverted(Polyhedron solid) {
    for (Polyhedron::Face& face : solid.faces) std::swap(face[1], face[2]);
    return solid;
}

/// A cube with its low corner at (a, a, a).
Polyhedron scaled_cube(double a, double size) {
    Polyhedron cube = unit_cube(0, 0, 0);
    for (Polyhedron::Point& point : cube.points)
        for (double& coordinate : point) coordinate = a + size * coordinate;
    return cube;
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

TEST_CASE("what CGAL demands of a solid is made so, or refused", "[polyhedra]") {
    const Polyhedron cube = unit_cube(0, 0, 0);
    Polyhedron turned_face = cube, split_edge = cube, bent_edge = cube, fin = cube;
    std::swap(turned_face.faces[3][0], turned_face.faces[3][1]);
    // A point within an edge of one face; the other keeps the whole edge, and a flat face is
    // between them.
    split_edge.points.push_back({0.5, 0.5, 0});
    split_edge.faces[0] = {0, 2, 8};
    split_edge.faces.push_back({8, 2, 3});
    split_edge.faces.push_back({0, 8, 3});
    bent_edge.points.push_back({0.5, 0.5, 0.25});
    bent_edge.faces[0] = {0, 2, 8};
    bent_edge.faces.push_back({8, 2, 3});
    bent_edge.faces.push_back({0, 8, 3});
    fin.points.push_back({2, 2, 0.5});
    fin.faces.push_back({3, 7, 8});
    fin.faces.push_back({7, 3, 8});
    const Polyhedron fan = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}},
                            {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
    const Polyhedron sheet = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}};
    const Polyhedron pillow = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                               {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}}};
    const Polyhedron tetrahedron = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    const Polyhedron tip = {{{0.5, 0.5, 1}, {0, 0, 2}, {1, 0, 2}, {0, 1, 2}},
                            {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}}};
    struct Case {
        const char* name;
        Polyhedron given;
        double volume;  ///< that of the solid; none: 0
        std::string wrong;
    };
    const std::string double_faces = "two of its faces have the same corners",
                      touching = "its faces cut or touch each other", open = "it is not closed",
                      edge = "more than two of its faces meet in an edge",
                      flat = "the corners of a face lie on one line";
    const Case cases[] = {
        {"inside out", inverted(cube), 1, ""},
        {"a face inside out", turned_face, 1, ""},
        {"a hollow", together({scaled_cube(0, 3), inverted(scaled_cube(1, 1))}), 26, ""},
        {"a hollow whose faces look outwards", together({scaled_cube(0, 3), scaled_cube(1, 1)}), 26,
         ""},
        {"a hollow with a core",
         together({inverted(scaled_cube(2, 1)), scaled_cube(0, 5), scaled_cube(1, 3)}),
         125 - 27 + 1, ""},
        {"two solids, one inside out", together({inverted(cube), unit_cube(3, 0, 0)}), 2, ""},
        {"a dent", bent_edge, 1 - 1.0 / 24, ""},
        {"each face twice", together({cube, cube}), 0, double_faces},
        {"each face and its back", together({cube, inverted(cube)}), 0, double_faces},
        {"two solids that share a face", together({cube, unit_cube(1, 0, 0)}), 0, double_faces},
        {"two solids that share an edge", together({cube, unit_cube(1, 1, 0)}), 0, edge},
        {"two solids that share a corner", together({cube, unit_cube(1, 1, 1)}), 0, touching},
        {"two solids that overlap", together({cube, unit_cube(0.5, 0.5, 0.5)}), 0, touching},
        {"a corner in a face", together({cube, tip}), 0, touching},
        {"a face of no area", split_edge, 0, flat},
        {"a triangle twice", sheet, 0, double_faces},
        {"a solid and a triangle twice", together({tetrahedron, sheet}), 0, double_faces},
        {"a solid and a triangle twice apart", together({unit_cube(9, 0, 0), sheet}), 0,
         double_faces},
        {"a square of both diagonals", pillow, 0, touching},
        {"a fin", fin, 0, double_faces},
        {"three faces at an edge", fan, 0, open},
        {"one triangle", {sheet.points, {{0, 1, 2}}}, 0, open}};
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const std::string wrong = c.wrong.empty() ? "" : "surface 1 bounds no solid: " + c.wrong;
        using enum SolidOperation;
        Polyhedron made;
        CHECK(combine(join, std::vector{c.given}, made) == wrong);
        if (wrong.empty()) CHECK(volume(made) == Approx(c.volume));
        // Beside itself, with faces in one plane and with none.
        for (const Vec3& by : {Vec3(0.25, 0, 0), Vec3(0.25, 0.125, 0.0625)}) {
            Polyhedron moved = c.given;
            for (Polyhedron::Point& point : moved.points)
                for (int axis = 0; axis < 3; ++axis) point[axis] += by[axis];
            std::map<SolidOperation, double> volumes;
            for (const SolidOperation operation : {join, intersect, subtract}) {
                const std::string said = combine(operation, std::vector{c.given, moved}, made);
                if (!wrong.empty()) CHECK(said == wrong);
                if (said.empty()) volumes[operation] = volume(made);
            }
            if (!wrong.empty() || by.y == 0) continue;
            CHECK(volumes[join] + volumes[intersect] == Approx(2 * c.volume));
            CHECK(volumes[intersect] + volumes[subtract] == Approx(c.volume));
        }
    }
}

TEST_CASE("work of operations is counted, and what counts it may end them", "[polyhedra]") {
    struct Ended {};
    static std::uint64_t steps, most;
    const WorkCount count = [](std::uint64_t added) {
        steps += added;
        if (steps > most) throw Ended();
    };
    const std::vector<Polyhedron> parts = {unit_cube(0, 0, 0), unit_cube(0.5, 0.5, 0.5)};
    const std::vector<SolidOperation> join = {SolidOperation::take, SolidOperation::take,
                                              SolidOperation::join};
    Polyhedron made;
    steps = 0;
    most = 1'000'000;
    REQUIRE(the_polyhedra().combine(join, parts, count, made) == "");
    CHECK(steps > 2'000);
    most = steps - 1;
    steps = 0;
    CHECK_THROWS_AS(the_polyhedra().combine(join, parts, count, made), Ended);
}

TEST_CASE("nothing is combined with something as well", "[polyhedra]") {
    using enum SolidOperation;
    const std::vector<Polyhedron> parts = {unit_cube(0, 0, 0), unit_cube(5, 0, 0),
                                           unit_cube(2, 0, 0)};
    const auto volume_of = [&](std::vector<SolidOperation> steps) {
        Polyhedron made;
        const std::string wrong = the_polyhedra().combine(steps, parts, uncounted, made);
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
    CHECK(the_polyhedra().combine(std::vector{SolidOperation::take}, std::vector{cube}, uncounted,
                                  made) == "");
}

}  // namespace candelabra
