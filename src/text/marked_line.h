// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One line of a source text as it is printed with marks below it: tabs widened, control characters
// replaced, a long line cut to what the marks are about. Called by excerpt.cpp, which adds the
// gutter. No row ends in white space or a newline.

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

/// The longest line that is shown whole, and the tab stops, in characters.
inline constexpr std::size_t max_columns = 100;
inline constexpr std::size_t tab_width = 4;

MarkedLine marked_line(std::string_view line, const std::vector<Mark>& marks,
                       const Palette& palette);

}  // namespace candelabra
