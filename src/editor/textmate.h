// SPDX-License-Identifier: GPL-3.0-or-later
// A TextMate grammar of the language, with which VS Code, Sublime Text, Kate and similar editors
// colour scenes. Generated from the vocabulary. Called for `--describe textmate`.
#pragma once

#include <string>

namespace candelabra {

/// Returns JSON for the scope name source.pov.
std::string textmate_grammar();

}  // namespace candelabra
