// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a font: no crash, and outlines whose numbers are numbers.
#include "font/outlines.h"
#include "fuzz/target.h"

#include <cmath>
#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view font(reinterpret_cast<const char*>(data), size);
    const TextOutlines made = text_outlines(font, "A\xc3\xa9 1,\xf0\x9f\x92\xa1", Vec2(0.1, 0));
    for (const auto& loop : made.loops)
        for (const CurvePiece& piece : loop)
            if (const Vec2 at = piece.at(0.5); !std::isfinite(at.x) || !std::isfinite(at.y))
                std::abort();
    return 0;
}
