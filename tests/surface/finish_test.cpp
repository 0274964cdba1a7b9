// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/finish.h"

#include "vocabulary/written.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a finish starts with POV-Ray 3.7's values", "[surface]") {
    const Finish finish;
    CHECK(finish.ambient == Rgb(0.1));
    CHECK(finish.diffuse == 0.6);
    CHECK(finish.phong_size == 40);
    CHECK(finish.roughness == 0.05);
    CHECK(finish.reflection == Reflection{});
    // Unset fields of a finish are not written.
    CHECK(written_fields(Finish::vocabulary, &finish).empty());
}

TEST_CASE("a finish is written in its own words", "[surface]") {
    Finish finish;
    finish.diffuse = 0.25;
    finish.phong = 1;
    CHECK(written_fields(Finish::vocabulary, &finish) == "diffuse 0.25 phong 1");
}

}  // namespace candelabra
