// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Guesses which name was meant by a misspelt one, for "did you mean". Letters left out, added,
// changed or swapped count; a difference in case hardly does. About one slip in three letters is
// forgiven, so that short words do not attract anything; nothing near is answered with nothing.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// The nearest of the names, or "" if none is near. Of equally near names the first is taken.
std::string nearest(std::string_view word, const std::vector<std::string_view>& names);

/// Up to `most` near names, each once, the nearest first.
std::vector<std::string> nearest_few(std::string_view word,
                                     const std::vector<std::string_view>& names,
                                     std::size_t most = 3);

}  // namespace candelabra
