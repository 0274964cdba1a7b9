// SPDX-License-Identifier: GPL-3.0-or-later
// Fonts to curves: where the letters of a text stand and what their outlines are. The one place
// that includes FreeType. Called when the language reads a `text`.
#pragma once

#include "shape/curve.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

struct TextOutlines {
    std::vector<std::vector<CurvePiece>> loops;  ///< an em is 1, the baseline is y = 0
    std::string problem;  ///< why there are none, as a sentence; empty when all is well
};

/// The letters of a text in UTF-8, side by side from x = 0 on, with the distances that the font
/// says (its kerning included); `offset` is added to each. The font is the content of its file
/// (TrueType and what else FreeType reads).
TextOutlines text_outlines(std::string_view font, std::string_view text, const Vec2& offset);

}  // namespace candelabra
