// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/version.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>

namespace candelabra {

TEST_CASE("the program states its name and its version", "[production]") {
    CHECK(std::ranges::count(version(), '.') == 2);
    CHECK(program_name() == "Candelabra " + std::string(version()));
}

}  // namespace candelabra
