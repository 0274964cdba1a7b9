// SPDX-License-Identifier: GPL-3.0-or-later
// Converts text in a font to curves: the positions and the outlines of its glyphs. The only module
// that includes FreeType. Called when the parser reads a `text` object.
#pragma once

#include "shape/curve.h"

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

struct TextOutlines {
    std::vector<std::vector<CurvePiece>> loops;  ///< in em units; the baseline is y = 0
    std::string problem;  ///< the reason for having no loops, as a clause; empty on success
};

/// Lays out UTF-8 text from x = 0 with the font's advances and kerning, and returns the outlines of
/// its glyphs. `offset` is added to every advance. `font` is the content of the font file: TrueType
/// or another outline format that FreeType reads.
TextOutlines text_outlines(std::string_view font, std::string_view text, const Vec2& offset);

}  // namespace candelabra
