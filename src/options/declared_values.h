// SPDX-License-Identifier: GPL-3.0-or-later
// Values that options declare for a scene: Declare=Height=3, and sets of them in a JSON file.
#pragma once

#include "options/options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Reads a number, on or off, a string in quotes, a vector `<1, 2, 3>` of two to five numbers, or a
/// colour `rgb <1, 0.5, 0>`; nothing for other texts.
std::optional<DeclaredValue> declared_value(std::string_view text);

/// Returns the value as declared_value() reads it.
std::string text_of(const DeclaredValue&);

/// Says why a name cannot be declared, as a sentence; empty if it can.
std::string problem_with_name(std::string_view name);

/// Reads a set of declarations: a JSON object of names with numbers, true or false, strings,
/// `[1, 2, 3]` for a vector, and `{"rgb": [1, 0.5, 0]}` for a colour. Returns nothing, with the
/// problem as a sentence, for other texts.
std::optional<std::vector<Declaration>> preset(std::string_view json, std::string& problem);

}  // namespace candelabra
