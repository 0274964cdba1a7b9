// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Text from an input made fit to be printed: whatever could move the cursor, change colours, turn
// the direction of writing or hide is replaced by a visible character, one for one, as are bytes
// that are not UTF-8. A tab is replaced, too; a caller that keeps tabs looks for them first.

#include "text/utf8.h"

#include <string>
#include <string_view>

namespace candelabra {

std::string printable(std::string_view text);

/// The bytes to print for one character, which stands at an offset in a text.
std::string harmless_character(std::string_view text, std::size_t offset, Character character);

}  // namespace candelabra
