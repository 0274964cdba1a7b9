// SPDX-License-Identifier: GPL-3.0-or-later
// Parses a file's text into its tree. parse() is a pure function of its arguments and returns a
// tree for any text. Where text could not be read, the tree has a node::Broken or lacks an element,
// and the diagnostics say why.
#pragma once

#include "syntax/open_macros.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"
#include "text/source.h"

namespace candelabra {

struct ParseOptions {
    /// Language version until the text sets one. It decides conditions on the version whose
    /// branches are not whole elements.
    double version = 3.7;
    /// Errors in a branch of a condition are kept in the tree instead of reported, because the
    /// branch may never be walked.
    bool postpones = false;
    /// Other files include this one: they may call open macros that it does not call itself.
    bool included = false;
    OpenMacroList* macros = nullptr;  ///< open macros known before the file; on return, after it
    IncludeReader reader = {};        ///< for the open macros of included files
};

Tree parse(SourceId, const SourceStore&, Names&, Diagnostics&, const ParseOptions& = {});

}  // namespace candelabra
