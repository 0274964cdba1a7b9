// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres for the tests of what an object looks like and how it is moved.
#pragma once

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

/// A sphere with this behind its radius, of which nothing is said.
inline Script sphere_with(const std::string& text, const std::string& before = {}) {
    Script done = run("#version 3.7; " + before + " sphere { 0, 1 " + text + " }");
    INFO(text << '\n' << done.text);
    REQUIRE(done.text.empty());
    return done;
}

}  // namespace candelabra
