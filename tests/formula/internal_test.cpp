// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/internal.h"

#include "formula/values.h"

#include <cmath>
#include <set>

namespace candelabra {

TEST_CASE("the table has POV-Ray's numbers, each name once", "[formula]") {
    std::set<std::string_view> names;
    int number = 0;
    for (const InternalFunction& function : internal_functions()) {
        if (number == 77) ++number;  // pattern { }
        CHECK(function.number == number++);
        CHECK(names.insert(function.name).second);
        CHECK(function.name.substr(0, 2) == "f_");
        CHECK(function.parameters >= 3);
    }
    CHECK(number == 79);
}

TEST_CASE("functions are found by their number", "[formula]") {
    REQUIRE(internal_function(70) != nullptr);
    CHECK(internal_function(70)->name == "f_torus");
    CHECK(internal_function(70)->parameters == 5);
    CHECK(internal_function(noise_function)->name == "f_noise3d");
    for (const int number : {-1, 77, 79, 1000}) CHECK(internal_function(number) == nullptr);
}

TEST_CASE("numbers of parts and octaves have no effect on time", "[formula]") {
    // This many tubes form a wall.
    CHECK(value_of("f_polytubes", {3, 1, 4, 1e9, 2, 0, 0, 0, 0}) == Approx(3));
    CHECK(value_of("f_polytubes", {3, 1, 4, 0.5, 2, 0, 0, 0, 0}) == 10000);
    CHECK(value_of("f_polytubes", {3, 1, 4, NAN, 2, 0, 0, 0, 0}) == 10000);
    for (const char* name : {"f_hetero_mf", "f_ridged_mf"})
        CHECK(value_of(name, {1, 2, 3, 1, 2, 1e9, 0.5, 1, 2}) ==
              value_of(name, {1, 2, 3, 1, 2, 100, 0.5, 1, 2}));
    CHECK(value_of("f_ridge", {1, 2, 3, 2, 1e9, 0.5, 0.5, 1, 2}) ==
          value_of("f_ridge", {1, 2, 3, 2, 100, 0.5, 0.5, 1, 2}));
}

TEST_CASE("polynomials are cut off far away", "[formula]") {
    CHECK(value_of("f_heart", {9, 9, 9, 1}) == -10);
    CHECK(value_of("f_heart", {9, 9, 9, -1}) == 10);
    CHECK(value_of("f_algbr_cyl1", {9, 9, 9, 1, 3, 0, 0, 0}) == 3);
}

}  // namespace candelabra
