// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Makes text from an input safe to print: replaces control characters, characters that change the
// writing direction or are invisible, and bytes that are not UTF-8 by visible characters, one for
// one. Tabs are replaced, too; callers that keep tabs handle them first.

#include "text/utf8.h"

#include <string>
#include <string_view>

namespace candelabra {

std::string printable(std::string_view text);

/// Returns the bytes to print for one character, which is at `offset` in the text.
std::string harmless_character(std::string_view text, std::size_t offset, Character character);

}  // namespace candelabra
