// SPDX-License-Identifier: GPL-3.0-or-later
#include "index/asked.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what was asked of late is known, and the rest is forgotten", "[index]") {
    Asked asked;
    for (std::uint32_t i = 0; i < 16; ++i) CHECK_FALSE(asked.before(i));
    for (std::uint32_t i = 0; i < 16; ++i) CHECK(asked.before(i));
    CHECK_FALSE(asked.before(16));
    CHECK(asked.before(16));
    CHECK(asked.before(1));
    CHECK_FALSE(asked.before(0));
}

}  // namespace candelabra
