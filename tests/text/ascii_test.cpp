// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/ascii.h"

#include <catch2/catch.hpp>

namespace candelabra {

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
    CHECK_FALSE(same_letters("[", "{"));  // as far apart as a letter's two cases
}

TEST_CASE("hexadecimal digits are of either case", "[text]") {
    for (const char c : std::string_view("09afAF")) CHECK(is_hex_digit(c));
    for (const char c : std::string_view("gG/:@`\xC3")) CHECK_FALSE(is_hex_digit(c));
}

TEST_CASE("words begin and end where no letter is beside them") {
    CHECK(begins_with_word("and b", "and"));
    CHECK(begins_with_word("and", "and"));
    CHECK_FALSE(begins_with_word("android", "and"));
    CHECK_FALSE(begins_with_word("", "and"));
    CHECK_FALSE(begins_with_word("and2", "and"));
    CHECK(ends_in_word("a #end", "end"));
    CHECK(ends_in_word("end", "end"));
    CHECK_FALSE(ends_in_word("trend", "end"));
    CHECK_FALSE(ends_in_word("a end ", "end"));
}

TEST_CASE("parts are taken off a text up to a sign", "[text]") {
    std::string_view text = "a,bc,,d";
    CHECK(take_until(text, ",") == "a");
    CHECK(take_until(text, ",;") == "bc");
    CHECK(take_until(text, ",") == "");
    CHECK(text == "d");
    CHECK(take_until(text, ",") == "d");
    CHECK(text.empty());
    CHECK(take_until(text, ",") == "");
}

}  // namespace candelabra
