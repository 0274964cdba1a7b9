// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/heard.h"

namespace candelabra {

void Heard::take(Stream stream, std::string_view plain) {
    if (stream == Stream::fatal) errors += plain;
    if (stream == Stream::warning) {
        if (warnings.size() < most_warnings)
            warnings.emplace_back(plain);
        else
            ++more_warnings;
    }
    if (stream != Stream::debug) return;
    said += plain;
    if (said.size() <= 2 * most_said) return;
    // From the beginning of a line on, if there is one.
    const std::size_t line = said.find('\n', said.size() - most_said);
    said.erase(0, line == said.npos ? said.size() - most_said : line + 1);
}

}  // namespace candelabra
