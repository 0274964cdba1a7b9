// SPDX-License-Identifier: GPL-3.0-or-later
#include "method/radiosity.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the defaults of radiosity are POV-Ray's", "[method]") {
    const Radiosity usual;
    CHECK(usual.recursion_limit == 2);
    CHECK(usual.brightness == 1);
    CHECK(usual.count == 35);
    CHECK_FALSE(usual.on);
    CHECK(Radiosity::vocabulary.name == "radiosity");
}

}  // namespace candelabra
