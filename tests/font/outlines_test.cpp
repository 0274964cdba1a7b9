// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/outlines.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

namespace candelabra {

TEST_CASE("what is no font is told from one", "[font]") {
    CHECK(text_outlines("", "A", Vec2(0)).problem == "it is no font that FreeType reads");
    CHECK(text_outlines("not a font", "A", Vec2(0)).loops.empty());
    // Formats that FreeType reads but the language does not offer: compressed fonts and bitmaps.
    for (const char* start : {"\x1f\x8b", "\x1f\x9d", "wOFF", "wOF2", "\1fcp", "STARTFONT 2.1"})
        CHECK(text_outlines(start + std::string(200, ' '), "A", Vec2(0)).problem ==
              "it is no font that FreeType reads");
}

TEST_CASE("the library's mark has the size of POV-Ray's, for every sign", "[font]") {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/stdlib/fonts/povlogo.ttf", std::ios::binary);
    const std::string font(std::istreambuf_iterator<char>(file), {});
    for (const char* text : {"P", "A"}) {
        const TextOutlines mark = text_outlines(font, text, Vec2(0));
        CHECK(mark.problem.empty());
        CHECK(mark.loops.size() == 4);  // the ring's two edges, the ball and the stem
        Vec2 high(0);
        for (const auto& loop : mark.loops)
            for (const CurvePiece& piece : loop) high = glm::max(high, piece.end);
        CHECK(high.x == Approx(0.67));
        CHECK(high.y == Approx(1.002));
    }
}

}  // namespace candelabra
