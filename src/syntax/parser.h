// SPDX-License-Identifier: GPL-3.0-or-later
// A file's text to its tree. A pure function of its arguments; whatever the text, it returns a
// tree: where something could not be read the tree has a node::Broken or lacks an element, and the
// diagnostics say why.
#pragma once

#include "syntax/open_macros.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"
#include "text/source.h"

namespace candelabra {

struct ParseOptions {
    /// Of the language, until the text names one; it decides conditions about the version whose
    /// branches are no whole elements.
    double version = 3.7;
    /// What is wrong in a branch of a condition is not reported but kept in the tree, for nobody
    /// may ever come there.
    bool postpones = false;
    /// Others include it: they may call the open macros that nobody calls here.
    bool included = false;
    OpenMacroList* macros = nullptr;  ///< open macros that are known before the file, then behind
    IncludeReader reader = {};        ///< for those of the files that it includes
};

Tree parse(SourceId, const SourceStore&, Names&, Diagnostics&, const ParseOptions& = {});

}  // namespace candelabra
