// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/examples.h"

#include "text/ascii.h"

#include <algorithm>

namespace candelabra {

bool contains_word(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool begins = at == 0 || !in_name(text[at - 1]);
        if (begins && (end == text.size() || !in_name(text[end]))) return true;
    }
    return false;
}

std::string_view example_of(std::string_view word, std::span<const std::string_view> examples) {
    const auto found = std::ranges::find_if(
        examples, [&](std::string_view example) { return contains_word(example, word); });
    if (found != examples.end()) return *found;
    return examples.empty() ? std::string_view() : examples.front();
}

}  // namespace candelabra
