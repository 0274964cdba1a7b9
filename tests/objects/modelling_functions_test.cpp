// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/modelling_functions.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::string printed_of_points(const std::string& script) {
    return debugged(
        "#version 3.7; #macro P(A) #debug concat(str(A, 0, 3), \" \") #end\n"
        "#declare S = array[5] { <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0.5, 0.5> }\n" +
        script);
}

}  // namespace

TEST_CASE("scatter gives points of a surface with their normals", "[objects]") {
    CHECK(printed_of_points("#declare A = scatter(sphere { <1, 0, 0>, 2 }, 0.5, 3);\n"
                            "#local Bad = 0; #for (I, 0, dimension_size(A, 1) - 1)\n"
                            "#if (abs(vlength(A[I][0] - x) - 2) > 1e-9 | "
                            "vdot(A[I][1], A[I][0] - x) < 1.999) #local Bad = Bad + 1; #end #end\n"
                            "P(Bad) P(dimension_size(A, 2)) P((dimension_size(A, 1) > 120))") ==
          "0.000 2.000 1.000 ");
}

TEST_CASE("triangles and cells of points", "[objects]") {
    CHECK(printed_of_points(
              "#declare T = delaunay(S); P(dimension_size(T, 1)) P(dimension_size(T, 2))") ==
          "4.000 3.000 ");
    CHECK(printed_of_points(
              "#declare C = voronoi_cell(S, 4, <0, 0>, <1, 1>); P(dimension_size(C, 1)) "
              "P(vlength(C[0] - <0.5, 0.5>))") == "4.000 0.500 ");
}

TEST_CASE("a scene's own names go before functions that are not reserved", "[objects]") {
    CHECK(printed_of_points("#macro scatter(A) P(A) #end scatter(7)") == "7.000 ");
    CHECK(printed_of_points("#declare delaunay = 3; P(delaunay)") == "3.000 ");
}

TEST_CASE("what cannot be scattered or divided is told", "[objects]") {
    CHECK(printed_of_points("#declare A = scatter(plane { y, 0 }, 1);") ==
          "error: this object has no end");
    CHECK(printed_of_points("#declare A = scatter(sphere { 0, 1 }, 0);") ==
          "error: the distance must be above 0");
    CHECK(printed_of_points("#declare A = scatter(sphere { 0, 1 }, 1e-5);") ==
          "error: so small a distance would give more than 1000000 points");
    CHECK(printed_of_points("#declare A = delaunay(array[3] { 1, 2, 3 });") ==
          "error: the points are an array of vectors <x, y>");
    CHECK(printed_of_points("#declare A = delaunay(array[3] { <0, 0>, <1, 1>, <2, 2> });") ==
          "error: the points lie on one line");
    CHECK(printed_of_points("#declare A = voronoi_cell(S, 5, 0, 1);") ==
          "error: there is no point 5: there are 5, counted from 0");
    CHECK(printed_of_points("#declare A = scatter(3, 1);") ==
          "error: `scatter` takes a declared object here, but this is a number");
}

}  // namespace candelabra
