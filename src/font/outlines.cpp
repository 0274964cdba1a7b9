// SPDX-License-Identifier: GPL-3.0-or-later
#include "font/outlines.h"

#include "text/utf8.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <array>
#include <memory>

namespace candelabra {

namespace {

using Library = std::unique_ptr<FT_LibraryRec_, decltype(&FT_Done_FreeType)>;
using Face = std::unique_ptr<FT_FaceRec_, decltype(&FT_Done_Face)>;

/// FreeType computes in integers. The outlines are shifted left by this many bits so that FreeType
/// does not round the on-curve points that a font implies midway between two control points.
constexpr int more_bits = 1;

/// Collects the outlines of one glyph.
struct Pen {
    std::vector<std::vector<CurvePiece>>& loops;
    Vec2 origin;
    double em;
    Vec2 at = Vec2(0);

    Vec2 point(const FT_Vector* p) const {
        constexpr double doubled = 1 << more_bits;
        return origin + Vec2(static_cast<double>(p->x), static_cast<double>(p->y)) / doubled / em;
    }
    void add(const CurvePiece& piece) {
        if (piece.start != piece.end || piece.factors[1] != Vec2(0)) loops.back().push_back(piece);
        at = piece.end;
    }
    /// Closes the current loop with a line, unless it already ends where it began.
    void close() {
        if (loops.empty() || loops.back().empty()) return;
        const Vec2 start = loops.back().front().start;
        if (at != start) add(line_piece(at, start));
    }
};

Pen& pen(void* user) { return *static_cast<Pen*>(user); }

int move_to(const FT_Vector* to, void* user) {
    pen(user).close();
    pen(user).loops.emplace_back();
    pen(user).at = pen(user).point(to);
    return 0;
}

int line_to(const FT_Vector* to, void* user) {
    pen(user).add(line_piece(pen(user).at, pen(user).point(to)));
    return 0;
}

int conic_to(const FT_Vector* control, const FT_Vector* to, void* user) {
    pen(user).add(conic_piece(pen(user).at, pen(user).point(control), pen(user).point(to)));
    return 0;
}

int cubic_to(const FT_Vector* control1, const FT_Vector* control2, const FT_Vector* to,
             void* user) {
    const std::array points = {pen(user).at, pen(user).point(control1), pen(user).point(control2),
                               pen(user).point(to)};
    pen(user).add(curve(bezier_curve, points).front());
    return 0;
}

/// Whether the bytes begin as TrueType, OpenType or PostScript fonts do. Without this check,
/// FreeType would try its readers of many other formats and unpack compressed files.
bool is_outline_font(std::string_view font) {
    using namespace std::string_view_literals;
    static constexpr auto starts = std::to_array<std::string_view>(
        {"\0\1\0\0"sv, "true", "ttcf", "OTTO", "typ1", "%!PS-AdobeFont", "%!FontType", "\x80\1"});
    return std::ranges::any_of(starts, [&](auto start) { return font.starts_with(start); });
}

/// Symbol fonts map their characters into the private use area from U+F000 on.
FT_UInt glyph_of(FT_Face face, char32_t code) {
    constexpr char32_t symbols = 0xF000;
    const FT_UInt found = FT_Get_Char_Index(face, code);
    return found == 0 && code < 0x100 ? FT_Get_Char_Index(face, symbols + code) : found;
}

}  // namespace

TextOutlines text_outlines(std::string_view font, std::string_view text, const Vec2& offset) {
    TextOutlines result;
    if (!is_outline_font(font)) return {{}, "it is no font that FreeType reads"};
    FT_Library opened = nullptr;
    if (FT_Init_FreeType(&opened) != 0) return {{}, "FreeType does not start"};
    const Library library(opened, FT_Done_FreeType);
    FT_Face read = nullptr;
    if (FT_New_Memory_Face(opened, reinterpret_cast<const FT_Byte*>(font.data()),
                           static_cast<FT_Long>(font.size()), 0, &read) != 0)
        return {{}, "it is no font that FreeType reads"};
    const Face face(read, FT_Done_Face);
    if (!FT_IS_SCALABLE(read) || read->units_per_EM == 0)
        return {{}, "its letters have no outlines"};
    if (!read->charmap && read->num_charmaps > 0) FT_Set_Charmap(read, read->charmaps[0]);

    Pen drawing{result.loops, Vec2(0), static_cast<double>(read->units_per_EM)};
    const FT_Outline_Funcs draw{move_to, line_to, conic_to, cubic_to, more_bits, 0};
    FT_UInt before = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        const FT_UInt glyph = glyph_of(read, character.code);
        if (FT_Load_Glyph(read, glyph, FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP) != 0)
            return {{}, "a letter of it is damaged"};
        const FT_GlyphSlot slot = read->glyph;
        FT_Vector kerning{0, 0};
        // The outline of the first glyph begins at x = 0.
        if (at == 0)
            drawing.origin.x = -static_cast<double>(slot->metrics.horiBearingX) / drawing.em;
        else if (FT_HAS_KERNING(read))
            FT_Get_Kerning(read, before, glyph, FT_KERNING_UNSCALED, &kerning);
        drawing.origin.x += static_cast<double>(kerning.x) / drawing.em;
        if (FT_Outline_Decompose(&slot->outline, &draw, &drawing) != 0)
            return {{}, "a letter of it is damaged"};
        drawing.close();
        drawing.origin += offset;
        drawing.origin.x += static_cast<double>(slot->metrics.horiAdvance) / drawing.em;
        before = glyph;
        at += character.length;
    }
    std::erase_if(result.loops, [](const auto& loop) { return loop.empty(); });
    return result;
}

}  // namespace candelabra
