// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnostics as JSON for programs such as editors: the facts of text/excerpt.h, with one object
// per line.
#pragma once

#include "text/diagnostic.h"
#include "text/source.h"

#include <string>
#include <string_view>

namespace candelabra {

/// Returns the object with a newline. Places have file, line, column, end_line, end_column (from 1,
/// in characters; the end is exclusive) and first, last (bytes from 0).
std::string to_json(const Diagnostic&, const SourceStore&);

/// Returns the output of #debug and its relatives in the same form.
std::string debug_to_json(std::string_view text);

}  // namespace candelabra
