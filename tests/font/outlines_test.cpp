// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/outlines.h"

#include <catch2/catch.hpp>

TEST_CASE("what is no font is told from one", "[font]") {
    CHECK(text_outlines("", "A", Vec2(0)).problem == "it is no font that FreeType reads");
    CHECK(text_outlines("not a font", "A", Vec2(0)).loops.empty());
}
