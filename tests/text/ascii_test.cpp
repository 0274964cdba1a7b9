// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/ascii.h"

#include <catch2/catch.hpp>

TEST_CASE("the case of ASCII letters, and of no others, makes no difference") {
    CHECK(lower_case('A') == 'a');
    CHECK(lower_case('Z') == 'z');
    for (const char c : {'@', '[', 'a', 'z', '0', '\xC4'}) CHECK(lower_case(c) == c);
    CHECK(lower_case("Light_Ring 3") == "light_ring 3");
    CHECK(same_letters("WIDTH", "width"));
    CHECK(same_letters("", ""));
    CHECK_FALSE(same_letters("width", "widths"));
    CHECK_FALSE(same_letters("Straße", "STRASSE"));
    CHECK_FALSE(same_letters("\xC4", "\xE4"));
    CHECK_FALSE(same_letters("[", "{"));  // as far apart as letters of two cases
}
