// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/scene_text.h"

#include "text/printable.h"

#include <algorithm>

namespace candelabra {

std::string printable_lines(std::string_view text) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\n\t"), text.size());
        shown += printable(text.substr(0, end));
        if (end < text.size()) shown += text[end];
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return shown;
}

std::string clipped(std::string_view name) {
    constexpr std::size_t most = 400, part = 190;
    if (name.size() <= most) return std::string(name);
    return std::string(name.substr(0, part)) + "..." + std::string(name.substr(name.size() - part));
}

}  // namespace candelabra
