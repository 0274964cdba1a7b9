// SPDX-License-Identifier: GPL-3.0-or-later
// Converts JSON to values of the language. Lists and objects become arrays, objects with the names
// of their members. Lists of lists or objects of equal shape become one array of more dimensions.
// true and false are 1 and 0; null, empty lists and empty objects are elements that are not set.
// Comments are skipped. Called by read_json(). Time and memory are linear in the text.
#pragma once

#include "interpret/value.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// The reason why a text cannot be read.
struct JsonProblem {
    std::size_t at = 0;  ///< byte offset of the error, if `placed`
    bool placed = false;
    std::string message;  ///< continues the name of the file
};

/// Maximum nesting of lists and objects.
inline constexpr std::size_t max_json_depth = 200;

/// Returns the value, or nothing and the reason. `most`: maximum number of values.
std::optional<Value> read_json(std::string_view text, std::size_t most, JsonProblem&);

}  // namespace candelabra
