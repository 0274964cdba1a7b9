// SPDX-License-Identifier: GPL-3.0-or-later
// Completions of a word that is being typed: the words of the innermost block, names of the scene's
// own files, names of the library that are for scenes, words of the language; directives after #,
// and files in the quotes of #include.
#pragma once

#include "editor/workspace.h"

#include <string>
#include <vector>

namespace candelabra {

struct Suggestion {
    enum Kind { field, item, function, name, macro, directive, file, word };

    std::string text;
    Kind kind = word;
    std::string detail;  ///< one line
    std::string help;
};

/// Returns suggestions without duplicates, the likely ones first.
std::vector<Suggestion> suggestions(Workspace&, const std::string& path, std::uint32_t offset);

}  // namespace candelabra
