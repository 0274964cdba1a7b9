// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/system_font.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a font that is not installed is not found", "[font]") {
    CHECK_FALSE(system_font(""));
    CHECK_FALSE(system_font("no such font.ttf"));
    CHECK_FALSE(system_font("../passwd"));
}

}  // namespace candelabra
