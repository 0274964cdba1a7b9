// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a font, or changes (place and value, four bytes each) of one of the system's: no
// crash, and outlines whose numbers are numbers.
#include "font/outlines.h"
#include "font/system_font.h"
#include "fuzz/target.h"

#include <cmath>
#include <cstdlib>

using namespace candelabra;

namespace {

/// Empty where the system has none of these.
const std::string& sound_font() {
    static const std::string font = [] {
        for (const char* name : {"timrom.ttf", "DejaVuSans.ttf", "LiberationSans-Regular.ttf"})
            if (auto found = system_font(name)) return *found;
        return std::string();
    }();
    return font;
}

/// Half of the changes are in the first kilobytes, where the tables and their directory begin.
std::string changed(std::string_view changes) {
    std::string font = sound_font();
    constexpr std::size_t step = 4, beginning = 4096;
    for (; changes.size() >= step && !font.empty(); changes.remove_prefix(step)) {
        const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(changes[i]); };
        const std::size_t place = byte(0) + 256u * byte(1) + 65536u * (byte(2) / 2);
        font[place % (byte(2) % 2 ? std::min(beginning, font.size()) : font.size())] = changes[3];
    }
    return font;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
    const std::string font = data[0] % 2 == 1 ? changed(rest) : std::string(rest);
    const TextOutlines made = text_outlines(font, "A\xc3\xa9 1,\xf0\x9f\x92\xa1", Vec2(0.1, 0));
    for (const auto& loop : made.loops)
        for (const CurvePiece& piece : loop)
            if (const Vec2 at = piece.at(0.5); !std::isfinite(at.x) || !std::isfinite(at.y))
                std::abort();
    return 0;
}
