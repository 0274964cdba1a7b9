// SPDX-License-Identifier: GPL-3.0-or-later
// How a word that is being typed may go on: what the block around it takes, names of the scene's
// own files, names of the library that are for scenes, words of the language; behind # directives,
// in the quotes of #include files.
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

/// The likely ones first; each text once.
std::vector<Suggestion> suggestions(Workspace&, const std::string& path, std::uint32_t offset);

}  // namespace candelabra
