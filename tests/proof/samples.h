// SPDX-License-Identifier: GPL-3.0-or-later
// Values of kinds that random numbers would hardly make: the table of the generator that is not the
// vocabulary.
#pragma once

#include <string_view>

namespace candelabra::proof {

/// What the item of that name has first in its braces (or after its name, if it has none) in place
/// of drawn values; empty: its values are drawn. Of `~a|b~` one is chosen. About as large as the unit
/// sphere.
std::string_view sample(std::string_view item);

/// The value of a word that only some values suit; empty: it is drawn.
std::string_view sample(std::string_view item, std::string_view field);

/// Whether the word is left out: it needs a file, or has no place beside drawn values.
bool left_out(std::string_view item, std::string_view field);

}  // namespace candelabra::proof
