// SPDX-License-Identifier: GPL-3.0-or-later
// The library of all picture formats, for tests that ask it directly.
#pragma once

#include "picture/formats.h"

#include <catch2/catch.hpp>

namespace candelabra {

inline const Formats& formats() {
    Diagnostics diagnostics;
    const Formats* found = picture_formats(diagnostics);
    REQUIRE(found);
    return *found;
}

}  // namespace candelabra
