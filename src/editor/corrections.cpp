// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/corrections.h"

#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>

namespace candelabra {

std::optional<std::string> correction(std::string_view message, std::string_view marked) {
    constexpr std::string_view question = "did you mean ";
    const std::size_t at = message.rfind(question);
    if (at == message.npos) return std::nullopt;
    std::string_view meant = message.substr(at + question.size());
    if (!meant.starts_with('`') && !meant.starts_with('"')) return std::nullopt;
    const std::size_t end = meant.find(meant.front(), 1);
    if (end == meant.npos || end == 1) return std::nullopt;
    meant = meant.substr(1, end - 1);
    if (marked.size() > 1 && marked.starts_with('"') && marked.ends_with('"'))
        return candelabra::message('"', meant, '"');
    const bool hash = marked.starts_with('#');
    const std::string_view word = marked.substr(hash ? 1 : 0);
    if (word.empty() || !std::ranges::all_of(word, in_name)) return std::nullopt;
    return candelabra::message(hash && !meant.starts_with('#') ? "#" : "", meant);
}

}  // namespace candelabra
