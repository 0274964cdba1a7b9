// SPDX-License-Identifier: GPL-3.0-or-later
#include "cgal/shapes.h"

namespace candelabra {

TEST_CASE("the hull of points has the outer ones as corners", "[polyhedra]") {
    std::vector<Polyhedron::Point> points = unit_cube(0, 0, 0).points;
    points.push_back({0.5, 0.5, 0.5});
    points.push_back({0.5, 0.5, 3});
    Polyhedron hull;
    REQUIRE(the_polyhedra().hull(points, hull) == "");
    CHECK(hull.points.size() == 9);
    CHECK(volume(hull) == Approx(1 + 2.0 / 3));
}

TEST_CASE("points in one plane have no hull", "[polyhedra]") {
    for (const int count : {0, 1, 2, 3, 4}) {
        const auto cube = unit_cube(0, 0, 0).points;
        Polyhedron hull;
        CHECK(the_polyhedra().hull(std::span(cube).first(static_cast<std::size_t>(count)), hull) ==
              "the points lie in one plane");
    }
}

TEST_CASE("a triangulation covers the hull of its points", "[polyhedra]") {
    const std::vector<std::array<double, 2>> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.4}};
    std::vector<Polyhedron::Face> faces;
    REQUIRE(the_polyhedra().triangulate(points, faces) == "");
    REQUIRE(faces.size() == 4);
    double twice = 0;
    for (const auto& [a, b, c] : faces) {
        const auto &p = points[a], &q = points[b], &r = points[c];
        twice += (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    }
    CHECK(twice == Approx(2));
    faces.clear();
    CHECK(the_polyhedra().triangulate(std::span(points).first(2), faces) ==
          "the points lie on one line");
}

}  // namespace candelabra
