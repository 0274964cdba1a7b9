// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/foreign.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

TEST_CASE("a foreign sign is known by its beginning", "[lexer]") {
    REQUIRE(
        foreign_sign("\u2013"
                     "1"));
    CHECK(foreign_sign("\u2013"
                       "1")
              ->meant == "-");
    CHECK_FALSE(foreign_sign("-1"));
    CHECK_FALSE(foreign_sign("\u00FC"));
    CHECK_FALSE(foreign_sign(""));
    CHECK_FALSE(foreign_sign("\xE2"));
}
