// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres for tests of the appearance and the transformations of objects.
#pragma once

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

/// Runs a scene whose sphere has `text` behind its radius. Requires that nothing is reported.
inline Script sphere_with(const std::string& text, const std::string& before = {}) {
    Script done = run("#version 3.7; " + before + " sphere { 0, 1 " + text + " }");
    INFO(text << '\n' << done.text);
    REQUIRE(done.text.empty());
    return done;
}

}  // namespace candelabra
