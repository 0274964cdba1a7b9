// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/outlines.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what is no font is told from one", "[font]") {
    CHECK(text_outlines("", "A", Vec2(0)).problem == "it is no font that FreeType reads");
    CHECK(text_outlines("not a font", "A", Vec2(0)).loops.empty());
    // Formats that FreeType reads, but the language does not name: packed ones, and bitmaps.
    for (const char* start : {"\x1f\x8b", "\x1f\x9d", "wOFF", "wOF2", "\1fcp", "STARTFONT 2.1"})
        CHECK(text_outlines(start + std::string(200, ' '), "A", Vec2(0)).problem ==
              "it is no font that FreeType reads");
}

}  // namespace candelabra
