// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/cosine_direction.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("directions about an axis have its cosine as their density", "[base]") {
    const Vec3 axis = unit(Vec3(1, -2, 0.5));
    double mean = 0, squares = 0;
    constexpr int steps = 200;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j) {
            const Vec3 d = cosine_direction(axis, {(i + 0.5) / steps, (j + 0.5) / steps});
            CHECK(length(d) == Approx(1));
            const double cosine = dot(d, axis);
            mean += cosine;
            squares += cosine * cosine;
        }
    CHECK(mean / (steps * steps) == Approx(2.0 / 3).epsilon(1e-3));
    CHECK(squares / (steps * steps) == Approx(0.5).epsilon(1e-3));
}

}  // namespace candelabra
