// SPDX-License-Identifier: GPL-3.0-or-later
// Dumps of tokens and trees, one token or node a line, for `--dump` and for comparing trees. A
// tree's dump omits places. Does not recurse, so trees of any depth can be written.
#pragma once

#include "syntax/tree.h"
#include "text/diagnostic.h"
#include "text/source.h"

#include <string>

namespace candelabra {

std::string dump(const Tree&, const Names&);

/// All tokens, one a line: place, kind, text.
std::string dump_tokens(SourceId, const SourceStore&, Names&, Diagnostics&);

}  // namespace candelabra
