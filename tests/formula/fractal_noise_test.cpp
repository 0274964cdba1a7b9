// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula/fractal_noise.h"

#include "formula/values.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("functions made of noise have POV-Ray's values", "[formula]") {
    check_values({
        {"f_hetero_mf", {1, 2, 6, 1.2, 1, 2}, 2.70263085},
        {"f_ridge", {2, 5.5, 0.5, 0.3, 0.7, 2}, 0.05662751},
        {"f_ridged_mf", {1, 2, 6, 1, 2, 2}, 1.29740084},
        {"f_noise3d", {}, 0.38040902},
        {"f_noise_generator", {1}, 0.22415345},
    });
}

TEST_CASE("an octave that has begun counts, and one more in part", "[formula]") {
    CHECK(value_of("f_hetero_mf", {-0.534, 0.082, -0.474, 0.7, 2.2, 4.5, 0.417, 2.5, 2}) ==
          Approx(0.3221454767));
    CHECK(value_of("f_hetero_mf", {-1.942, -2.271, -2.316, 0.7, 2.2, 4.5, 0.028, 2.5, 1}) ==
          Approx(-0.6753824736));
}

TEST_CASE("each call of f_ridged_mf has its own weights", "[formula]") {
    const std::vector<double> rough = {0.3, 0.4, 0.5, 0.1, 2, 6, 1, 2, 2};
    std::vector<double> smooth = rough;
    smooth[3] = 1;
    const double first = value_of("f_ridged_mf", rough);
    CHECK(value_of("f_ridged_mf", smooth) < first);
    CHECK(value_of("f_ridged_mf", rough) == first);
}

}  // namespace candelabra
