// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Finds names similar to a misspelt one, for "did you mean". Counts letters that are omitted,
// added, changed or swapped; a difference in case counts little. Tolerates about one slip in three
// letters, so that short words do not match arbitrary names. Where none is near, the only name that
// begins with the word is meant.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Returns the nearest of the names, or "" if none is near; the first of equally near names.
std::string nearest(std::string_view word, const std::vector<std::string_view>& names);

/// Returns up to `most` near names, nearest first, without duplicates.
std::vector<std::string> nearest_few(std::string_view word,
                                     const std::vector<std::string_view>& names,
                                     std::size_t most = 3);

}  // namespace candelabra
