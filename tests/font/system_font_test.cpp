// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/system_font.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a font that is not installed is not found", "[font]") {
    CHECK_FALSE(system_font(""));
    CHECK_FALSE(system_font("no such font.ttf"));
    CHECK_FALSE(system_font("../passwd"));
}

TEST_CASE("POV-Ray's fonts have others that stand in for them", "[font]") {
    CHECK(fonts_like("timrom.ttf").front() == std::string("LiberationSerif-Regular.ttf"));
    CHECK(fonts_like("cyrvetic").back() == std::string("DejaVuSans.ttf"));
    CHECK(fonts_like("crystal.ttf").size() == 2);
    CHECK(fonts_like("povlogo.ttf").empty());
    CHECK(fonts_like("arial.ttf").empty());
}

}  // namespace candelabra
