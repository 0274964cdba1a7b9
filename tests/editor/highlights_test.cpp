// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/highlights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the offsets of the highlights for the cursor at |, with w for writes and r for reads.
std::string lit(const std::string& marked) {
    const std::size_t cursor = marked.find('|');
    std::string text = marked;
    text.erase(cursor, 1);
    Names names;
    const EditedFile file = read_tokens(text, names);
    std::string all;
    for (const WordHighlight& each : highlights(file, static_cast<std::uint32_t>(cursor)))
        all += std::to_string(each.place.first) + (each.kind == WordHighlight::write  ? "w "
                                                   : each.kind == WordHighlight::read ? "r "
                                                                                      : " ");
    return all;
}

}  // namespace

TEST_CASE("a name is shown wherever the file mentions it") {
    CHECK(lit("#declare A = 1; |A + A // A\n#declare A = 2;") == "9w 16r 20r 36w ");
    CHECK(lit("#macro M(B) B| #end B") == "9w 12r 19r ");
    CHECK(lit("sphe|re { }").empty());
    CHECK(lit("|").empty());
    CHECK(lit("A  |  ").empty());
}

TEST_CASE("the parts of a directive are shown together") {
    CHECK(lit("#if (A) #while (B) C #end #el|se D #end") == "0 26 34 ");
    CHECK(lit("#if (A) #wh|ile (B) C #end #else D #end") == "8 21 ");
    CHECK(lit("#i|f (A) B").empty());
    CHECK(lit("#e|nd").empty());
    CHECK(lit("#incl|ude \"a\"").empty());
}

}  // namespace candelabra
