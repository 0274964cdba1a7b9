// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the place of a missing closer by the indentation of the text.
#pragma once

#include "syntax/token.h"

#include <optional>
#include <string_view>

namespace candelabra {

struct Misindented {
    Token opener, closer;
};

/// The first `}` or `#end` at the start of a line that is indented less than the line of its
/// opener: a closer before it is missing. `directives`: examine directives, not braces.
std::optional<Misindented> misindented(std::string_view text, bool directives);

}  // namespace candelabra
