// SPDX-License-Identifier: GPL-3.0-or-later
// Where an end is missing, by how the text is indented.
#pragma once

#include "syntax/token.h"

#include <optional>
#include <string_view>

namespace candelabra {

struct Misindented {
    Token opener, closer;
};

/// The first `}` or `#end` at the start of a line that stands further left than the line of what it
/// closes: one before it is missing. `directives`: look at these, not at braces.
std::optional<Misindented> misindented(std::string_view text, bool directives);

}  // namespace candelabra
