// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/block.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what follows from a hole is not told of", "[reading]") {
    CHECK(run("#version 3.7; sphere { Nothing, 1 }").said.size() == 1);
    CHECK(run("#version 3.7; #declare A = torus { 0, x } object { A translate x } union { A A }")
              .said.size() == 1);
    CHECK(run("#version 3.7; #declare T = texture { pigment { Nothing } } sphere { 0, 1 texture { "
              "T } }")
              .said.size() == 1);
}

TEST_CASE("a word without effect is told of at its first place only", "[reading]") {
    CHECK(run("#version 3.7; sphere { 0, 1 sturm } sphere { 0, 1 sturm }").said.size() == 1);
}

}  // namespace candelabra
