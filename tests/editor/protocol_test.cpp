// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/protocol.h"

#include <catch2/catch.hpp>

#include <tuple>

namespace candelabra {

TEST_CASE("files have URIs") {
    const std::string path = "/a b/ä%.pov";
    CHECK(uri_of(path) == "file:///a%20b/%C3%A4%25.pov");
    CHECK(path_of(uri_of(path)) == path);
    CHECK(path_of("file:///a%2") == "/a%2");
    CHECK(path_of("untitled:1") == "untitled:1");
}

TEST_CASE("places are lines and units of UTF-16") {
    const std::string text = "a\nä\xF0\x9F\x92\xA1z\r\nb";
    struct Case {
        int line, character;
        std::uint32_t offset;
    };
    for (const Case& each : {Case{0, 0, 0}, Case{0, 1, 1}, Case{1, 0, 2}, Case{1, 1, 4},
                             Case{1, 3, 8}, Case{1, 4, 9}, Case{2, 1, 12}}) {
        const Json position = {{"line", each.line}, {"character", each.character}};
        CAPTURE(each.line, each.character);
        CHECK(offset_of(text, position) == each.offset);
        CHECK(position_of(text, each.offset) == position);
        const Part place{0, each.offset};
        CHECK(LineTable(text).range_of(place) == range_of(text, place));
    }
    CHECK(offset_of(text, {{"line", 1}, {"character", 99}}) == 9);
    CHECK(offset_of(text, {{"line", 99}, {"character", 0}}) == text.size());
    CHECK(offset_of(text, Json()) == 0);
    CHECK(position_of(text, 99) == Json({{"line", 2}, {"character", 1}}));
}

TEST_CASE("brackets are counted before a message is parsed") {
    CHECK_FALSE(nests_deeper("[{}]", 2));
    CHECK(nests_deeper("[{}]", 1));
    CHECK_FALSE(nests_deeper(R"(["[[[[", "\"[[["])", 1));
    CHECK_FALSE(nests_deeper("[][][]", 1));
    CHECK(nests_deeper(std::string(200'000, '['), 64));
    CHECK_FALSE(nests_deeper("\"\\", 1));
}

TEST_CASE("lines end as the protocol says") {
    const std::string text = "a\rb\r\nc\n\rd";
    const LineTable lines(text);
    for (const auto& [offset, line, character] : {std::tuple{1u, 0, 1},
                                                  {2u, 1, 0},
                                                  {3u, 1, 1},
                                                  {5u, 2, 0},
                                                  {7u, 3, 0},
                                                  {8u, 4, 0},
                                                  {9u, 4, 1}}) {
        const Json position = {{"line", line}, {"character", character}};
        CAPTURE(offset);
        CHECK(lines.position_of(offset) == position);
        CHECK(lines.line_of(offset) == std::size_t(line));
        CHECK(offset_of(text, position) == offset);
    }
}

TEST_CASE("a walk over a text has the lines and columns of the table") {
    for (const std::string text : {"", "a", "\n", "a\n\nb", "\xC3\xA4\xF0\x9F\x92\xA1z\r\nb\rc"}) {
        const LineTable lines(text);
        TextWalk every(text);
        for (std::uint32_t offset = 0; offset <= text.size() + 1; ++offset) {
            const bool inside = offset < text.size() && (text[offset] & 0xC0) == 0x80;
            if (inside) continue;
            CAPTURE(text, offset);
            const Json position = lines.position_of(offset);
            every.go_to(offset);
            CHECK(position == Json{{"line", every.line()}, {"character", every.column()}});
            TextWalk once(text);
            once.go_to(offset);
            CHECK(position == Json{{"line", once.line()}, {"character", once.column()}});
        }
    }
}

}  // namespace candelabra
