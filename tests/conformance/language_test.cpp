// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/vectors.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("scripts print what POV-Ray 3.7 prints", "[language]") {
    CHECK(check_scripts("conformance/language") > 520);
}

}  // namespace candelabra
