// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/foreign.h"

#include "syntax/parsed.h"

#include <catch2/catch.hpp>

namespace candelabra {

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

TEST_CASE("directives of other languages stand for some of this one", "[lexer]") {
    CHECK(foreign_directive("print") == "debug");
    CHECK(foreign_directive("endif") == "end");
    CHECK(foreign_directive("declare").empty());
    CHECK(foreign_directive("").empty());
}

TEST_CASE("words of other programs stand for words of blocks", "[lexer]") {
    using Words = std::vector<std::string_view>;
    CHECK(foreign_word("fov") == Words{"angle"});
    CHECK(foreign_word("target") == Words{"look_at", "point_at"});
    CHECK(foreign_word("angle").empty());
    CHECK(foreign_name("then").starts_with("an #if needs no"));
    CHECK(foreign_name("Tower").empty());
}

TEST_CASE("six hexadecimal digits are a colour", "[lexer]") {
    CHECK(hexadecimal_colour("ff8000") == "srgb <255, 128, 0>/255");
    CHECK(hexadecimal_colour("000000") == "srgb <0, 0, 0>/255");
    CHECK(hexadecimal_colour("ff80").empty());
    CHECK(hexadecimal_colour("ff80zz").empty());
    CHECK(hexadecimal_colour("").empty());
}

}  // namespace candelabra
