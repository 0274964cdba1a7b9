// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/examples.h"

#include <catch2/catch.hpp>

#include <array>

namespace candelabra {

TEST_CASE("an example is found by a whole word", "[vocabulary]") {
    constexpr std::array<std::string_view, 3> texts = {"torus { 1, 0.4 }", "box { 0, 1 open_top }",
                                                       "cone { 0, 1, y, 0 open }"};
    CHECK(example_of("open", texts) == texts[2]);
    CHECK(example_of("torus", texts) == texts[0]);
    CHECK(example_of("nothing", texts) == texts[0]);
    CHECK(example_of("open", {}).empty());
    CHECK(contains_word("open", "open"));
    CHECK_FALSE(contains_word("reopen openly", "open"));
    CHECK_FALSE(contains_word("", "open"));
}

}  // namespace candelabra
