// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/indices.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a path is as many indices as it has parts", "[arrays]") {
    Indices indices;
    CHECK(indices.add(7));
    CHECK(indices.add(std::string("lamps.3.radiance")));
    CHECK(indices.add(std::string("red")));
    CHECK_FALSE(indices.expand(0));
    CHECK_FALSE(indices.expand(2));
    CHECK(indices.expand(1));
    REQUIRE(indices.count == 5);
    CHECK(indices.values[0] == 7);
    CHECK(*indices.text(1) == "lamps");
    CHECK(indices.values[2] == 3);
    CHECK_FALSE(indices.text(2));
    CHECK(*indices.text(3) == "radiance");
    CHECK(*indices.text(4) == "red");
}

TEST_CASE("there are at most sixteen indices", "[arrays]") {
    Indices indices;
    for (int i = 0; i < 15; ++i) CHECK(indices.add(i));
    CHECK(indices.add(std::string("a.b")));
    CHECK_FALSE(indices.add(16));
    CHECK_FALSE(indices.expand(15));
    CHECK(indices.count == 16);
}

}  // namespace candelabra
