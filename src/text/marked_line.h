// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Formats one source line with marks below it: expands tabs, replaces control characters, and cuts
// a long line to the part around the marks. Called by excerpt.cpp, which adds the gutter. No row
// ends in white space or a newline.

#include "text/palette.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Bytes [first, last) of the line; an empty range is marked like one character.
struct Mark {
    std::size_t first = 0;
    std::size_t last = 0;
    bool primary = false;
    std::string text;
};

struct MarkedLine {
    std::string source;
    std::vector<std::string> below;
};

/// The length up to which a line is shown whole, and the distance of tab stops, in characters.
inline constexpr std::size_t max_columns = 100;
inline constexpr std::size_t tab_width = 4;

MarkedLine marked_line(std::string_view line, const std::vector<Mark>& marks,
                       const Palette& palette);

}  // namespace candelabra
