// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Terminal colours of a printed diagnostic, as strings to put around its parts. The strings of the
// plain palette are empty, so that the same code produces both forms of the text.

#include "text/diagnostic.h"

#include <string>
#include <string_view>

namespace candelabra {

struct Palette {
    std::string_view primary;  ///< the severity, and the carets
    std::string_view frame;    ///< gutter, arrows, secondary marks
    std::string_view strong;   ///< the message
    std::string_view help;
    std::string_view off;

    std::string paint(std::string_view colour, std::string_view text) const {
        if (text.empty()) return {};
        return std::string(colour) + std::string(text) + std::string(off);
    }
};

constexpr Palette palette(Severity severity, bool coloured) {
    if (!coloured) return {};
    Palette colours{"\x1b[1;31m", "\x1b[1;34m", "\x1b[1m", "\x1b[1;32m", "\x1b[0m"};
    if (severity == Severity::warning) colours.primary = "\x1b[1;33m";
    if (severity == Severity::note) colours.primary = "\x1b[1;36m";
    return colours;
}

}  // namespace candelabra
