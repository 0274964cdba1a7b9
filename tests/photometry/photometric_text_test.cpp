// SPDX-License-Identifier: GPL-3.0-or-later
#include "photometry/photometric_text.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::vector<std::string> text_lines(std::string_view bytes) {
    bool latin = false;
    return lines_of(bytes, latin);
}

}  // namespace

TEST_CASE("lines may end in any way, and are UTF-8", "[photometry]") {
    CHECK(text_lines("a\r\nb\nc\rd") == std::vector<std::string>{"a", "b", "c", "d"});
    CHECK(text_lines("a\n\nb\n") == std::vector<std::string>{"a", "", "b"});
    CHECK(text_lines("\xef\xbb\xbfx") == std::vector<std::string>{"x"});
    CHECK(text_lines("").empty());
    bool latin = false;
    CHECK(lines_of("M\xfcller", latin) == std::vector<std::string>{"M\xc3\xbcller"});
    CHECK(latin);
    CHECK(lines_of("M\xc3\xbcller", latin) == std::vector<std::string>{"M\xc3\xbcller"});
    CHECK_FALSE(latin);
}

TEST_CASE("numbers come out of lines however they are divided", "[photometry]") {
    const std::vector<std::string> text = {"head", " 1, 2.5,,\t-3e2;", "", "+4", "x 5"};
    NumberStream stream(text, 1);
    for (const double expected : {1.0, 2.5, -300.0, 4.0}) CHECK(stream.next() == expected);
    CHECK(stream.line() == 4);
    CHECK_FALSE(stream.next());
    CHECK(stream.stray() == "x");
    CHECK(stream.line() == 5);
    CHECK(stream.next() == 5.0);
    CHECK_FALSE(stream.next());
    CHECK(stream.stray().empty());
}

TEST_CASE("a number fills its text", "[photometry]") {
    CHECK(number_of(" 1.5 ") == 1.5);
    for (const char* text : {"", "1.5x", "nan", "inf", "1e999", "1 2", "0x10", "++1"}) {
        CAPTURE(text);
        CHECK_FALSE(number_of(text));
    }
}

}  // namespace candelabra
