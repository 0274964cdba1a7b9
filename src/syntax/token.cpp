// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/token.h"

#include <array>

namespace candelabra {

namespace {

/// In the order of TokenKind.
// clang-format off
constexpr auto names = std::to_array<std::string_view>({
    "end of file", "name", "word", "layer", "constant", "unary function", "function",
    "colour prefix", "channel", "number", "vector", "string", "colour", "array",
    "function literal", "deprecated", "once", "unofficial", "powers", "mixed",
    "optional", "#declare", "#message",
    "#undef", "#if", "#ifdef", "#elseif", "#else", "#end", "#while", "#for", "#switch", "#case",
    "#range", "#break", "#macro", "#include", "#default", "#version", "#fopen", "#fclose", "#read",
    "#write", "{", "}", "(", ")", "[", "]", "<", ">", "<=", ">=", "=", "!=", "&", "|", "?", ":",
    "+", "-", "*", "/", "!", ".", ",", ";", "between",
    "goes on", "joins", "nothing", "continues", "gives", "leads",
});
// clang-format on
static_assert(names.size() == static_cast<std::size_t>(TokenKind::leads) + 1);

}  // namespace

std::string_view name(TokenKind kind) { return names[static_cast<std::size_t>(kind)]; }

}  // namespace candelabra
