// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/interior.h"

#include "vocabulary/written.h"

#include <catch2/catch.hpp>

TEST_CASE("an interior starts as air and is written in its own words", "[surface]") {
    Interior interior;
    CHECK(interior.ior == 1);
    CHECK(written_fields(Interior::vocabulary, &interior).empty());
    interior.ior = 1.5;
    CHECK(written_fields(Interior::vocabulary, &interior) == "ior 1.5");
}
