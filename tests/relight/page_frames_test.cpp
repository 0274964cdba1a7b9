// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/page_frames.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("frames of a page are bytes of factors, as differences", "[relight]") {
    const LampList lamps({{"A", 1}, {"B", 2}}, {0, 0, 1}, {1, 1, 1});
    Diagnostics diagnostics;
    LightShow show(lamps);
    const auto alone = page_frames(show, 100);
    REQUIRE(alone);
    CHECK(alone->count == 1);
    CHECK(alone->grey);
    CHECK(alone->bytes == "\xFF\xFF\xFF");
    show.set(show_of_table("A,B[0],B[1]\n4,1,0\n0,1,4\n", "x", show.names(), 25, diagnostics));
    const auto grey = page_frames(show, 6);
    REQUIRE(grey);
    CHECK(grey->count == 2);
    CHECK(grey->scale == 4);
    CHECK(grey->bytes == std::string("\xFF\x80\x00\x01\x00\xFF", 6));
    CHECK_FALSE(page_frames(show, 5));
    REQUIRE(show.set("A=#ff0000", diagnostics));
    const auto coloured = page_frames(show, 18);
    REQUIRE(coloured);
    CHECK_FALSE(coloured->grey);
    CHECK(coloured->bytes.size() == 18);
    CHECK_FALSE(page_frames(show, 17));
}

}  // namespace candelabra
