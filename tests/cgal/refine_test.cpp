// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/elementary.h"
#include "cgal/shapes.h"

#include <limits>
#include <numbers>

namespace candelabra {

namespace {

/// Two pyramids of that many sides on one another; their tips are the first points.
Polyhedron double_pyramid(int sides) {
    Polyhedron made;
    made.points = {{0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < sides; ++i) {
        const auto [sine, cosine] = math::sin_cos(2 * std::numbers::pi * i / sides);
        made.points.push_back({cosine, sine, 0});
        const int here = 2 + i, next = 2 + (i + 1) % sides;
        made.faces.push_back({0, here, next});
        made.faces.push_back({1, next, here});
    }
    return made;
}

}  // namespace

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

TEST_CASE("a corner of any number of faces moves by the bits of our own cosine", "[polyhedra]") {
    struct Rule {
        SubdivisionRule rule;
        double (*share)(double cosine);  ///< of the way to the mean of the points around it
    };
    const Rule rules[] = {
        {SubdivisionRule::loop, [](double c) { return (40 - (3 + 2 * c) * (3 + 2 * c)) / 64; }},
        {SubdivisionRule::root3, [](double c) { return (4 - 2 * c) / 9; }}};
    for (const Rule& rule : rules)
        for (int sides = 3; sides < 100; ++sides) {
            CAPTURE(sides);
            Polyhedron made;
            REQUIRE(the_polyhedra().subdivide(double_pyramid(sides), rule.rule, 1, made) == "");
            const double share = rule.share(math::cos(2 * std::numbers::pi / sides));
            CHECK(made.points[0][2] == 1 - share);
            CHECK(made.points[1][2] == share - 1);
        }
}

TEST_CASE("operations stand what no modeller writes", "[polyhedra]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), far = 1e308;
    const std::vector<std::pair<const char*, Polyhedron>> shapes = {
        {"an unused point", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}}}},
        {"a corner too far", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}},
        {"a corner below 0", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, -1, 2}}}},
        {"no number", {{{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}},
        {"numbers that overflow", {{{far, far, 0}, {-far, far, 0}, {0, -far, far}}, {{0, 1, 2}}}},
        {"a face twice", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 1, 2}}}},
        {"a face and its back", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}}},
        {"a face without area", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}},
        {"a face of one point", {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}}}},
        {"three faces at an edge",
         {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}},
          {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}},
        {"two fans at a point",
         {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}}}};
    for (const auto& [name, shape] : shapes) {
        CAPTURE(name);
        for (const SubdivisionRule rule : {SubdivisionRule::loop, SubdivisionRule::root3}) {
            Polyhedron made;
            const std::string wrong = the_polyhedra().subdivide(shape, rule, 2, made);
            CHECK(wrong.empty() == !made.faces.empty());
        }
        Polyhedron made;
        the_polyhedra().hull(shape.points, made);
        const std::array steps = {SolidOperation::take, SolidOperation::take,
                                  SolidOperation::subtract};
        const std::array solids = {unit_cube(0, 0, 0), shape};
        CHECK(the_polyhedra().combine(steps, solids, uncounted, made) != "");
    }
    Polyhedron made;
    CHECK(the_polyhedra().subdivide(shapes[0].second, SubdivisionRule::loop, 1, made) == "");
    CHECK(made.faces.size() == 4);
    CHECK(the_polyhedra().subdivide(shapes[3].second, SubdivisionRule::loop, 1, made) ==
          "a number of entry 1 is not finite");
}

}  // namespace candelabra
