// SPDX-License-Identifier: GPL-3.0-or-later
// Small letters for numbers on pictures, made of squares, so that they need no font.
#pragma once

#include "base/image.h"

#include <string_view>

namespace candelabra {

struct PixelPlace {
    int x, y;
};

/// Height of a letter, in squares.
inline constexpr int letter_height = 7;

/// The width of a text in pixels; `size`: of a square.
int text_width(std::string_view text, int size);

/// Writes digits, `.`, `-`, `+`, `/`, `%`, `e` and the letters of `lx` and `cd/m2`; others are
/// blank. `at`: the upper left corner. What lies outside of the picture is left out.
void write_text(Image&, PixelPlace at, std::string_view text, int size, const Rgb& colour);

}  // namespace candelabra
