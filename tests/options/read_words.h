// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the words of a command line, for tests of the options.
#pragma once

#include "options/options.h"

#include <catch2/catch.hpp>

#include <string_view>
#include <vector>

namespace candelabra {

inline Options read(std::vector<std::string_view> words, bool good = true) {
    Diagnostics diagnostics;
    Options options = read_options(words, diagnostics);
    CAPTURE(words);
    CHECK(diagnostics.failed() == !good);
    return options;
}

}  // namespace candelabra
