// SPDX-License-Identifier: GPL-3.0-or-later
// The language as a TextMate grammar, by which editors colour scenes: VS Code, Sublime Text, Kate's
// and others' relatives. Made from the vocabulary. Called for `--describe textmate`.
#pragma once

#include <string>

namespace candelabra {

/// JSON, for the scope name source.pov.
std::string textmate_grammar();

}  // namespace candelabra
