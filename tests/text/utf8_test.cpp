// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/utf8.h"

#include <catch2/catch.hpp>

#include <string_view>

namespace candelabra {

TEST_CASE("characters are decoded, and bytes of no character stand alone") {
    struct Case {
        std::string_view text;
        char32_t code;
        std::size_t length;
        bool valid;
    };
    const Case cases[] = {
        {"a", U'a', 1, true},
        {"é", U'é', 2, true},
        {"€", U'€', 3, true},
        {"🙂", U'🙂', 4, true},
        {"\x80", 0x80, 1, false},      // a continuation byte without a lead byte
        {"\xC3", 0xC3, 1, false},      // truncated
        {"\xC3(", 0xC3, 1, false},     // not continued
        {"\xC0\x80", 0xC0, 1, false},  // overlong
        {"\xE0\x80\x80", 0xE0, 1, false},
        {"\xED\xA0\x80", 0xED, 1, false},      // half of a surrogate pair
        {"\xF4\x90\x80\x80", 0xF4, 1, false},  // above the last code point
        {"\xFF", 0xFF, 1, false},
    };
    for (const Case& each : cases) {
        CAPTURE(each.text);
        const Character found = character_at(each.text, 0);
        CHECK(found.code == each.code);
        CHECK(found.length == each.length);
        CHECK(found.valid == each.valid);
    }
}

TEST_CASE("characters are counted in any bytes") {
    CHECK(character_count("") == 0);
    CHECK(character_count("aé€🙂") == 4);
    CHECK(character_count("a\xE9\xE9z") == 4);
}

}  // namespace candelabra
