// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/formats.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("the library of formats opens once", "[picture]") {
    Diagnostics diagnostics;
    const Formats* formats = picture_formats(diagnostics);
    REQUIRE(formats);
    CHECK(formats == picture_formats(diagnostics));
    CHECK(diagnostics.all().empty());
}

}  // namespace candelabra
