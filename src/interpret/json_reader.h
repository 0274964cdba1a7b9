// SPDX-License-Identifier: GPL-3.0-or-later
// JSON as values of the language: lists and objects are arrays, those of objects with the names of
// their members; lists of lists or of objects that are alike are one array of more dimensions.
// true and false are 1 and 0; null and what is empty are elements that are not set. Called by
// read_json(). Comments are left out. Time and memory grow with the text and no faster.
#pragma once

#include "interpret/value.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Why a text cannot be read.
struct JsonProblem {
    std::size_t at = 0;  ///< the byte where it was noticed, when `placed`
    bool placed = false;
    std::string message;  ///< goes on behind the name of the file
};

/// Lists and objects inside each other.
inline constexpr std::size_t max_json_depth = 200;

/// The value, or nothing and the reason. `most`: how many values there may be.
std::optional<Value> read_json(std::string_view text, std::size_t most, JsonProblem&);

}  // namespace candelabra
