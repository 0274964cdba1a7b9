// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/clipping.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what cuts an object and what bounds it are kept apart", "[objects]") {
    const Script done =
        run("#version 3.7; sphere { 0, 2 clipped_by { plane { x, 0 } plane { y, 0 } } "
            "bounded_by { box { -1, 1 } } }");
    CHECK(done.text.empty());
    REQUIRE(done.object().clipping);
    CHECK(done.object().clipping->clips.size() == 2);
    CHECK(done.object().clipping->bounds.size() == 1);
    CHECK_FALSE(run("#version 3.7; sphere { 0, 2 }").object().clipping);
}

TEST_CASE("what cannot cut an object is told of once", "[objects]") {
    CHECK(complaint("sphere { 0, 2 clipped_by { 3 } }").starts_with("error"));
    CHECK(complaint("sphere { 0, 2 bounded_by { pigment { rgb 1 } } }").starts_with("error"));
}

}  // namespace candelabra
