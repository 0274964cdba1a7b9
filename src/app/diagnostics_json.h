// SPDX-License-Identifier: GPL-3.0-or-later
// Diagnostics for programs, such as editors: the facts of text/excerpt.h as JSON, an object on a
// line of its own for each.
#pragma once

#include "text/diagnostic.h"
#include "text/source.h"

#include <string>
#include <string_view>

namespace candelabra {

/// The object, with a line end. Places have file, line, column, end_line, end_column (from 1, in
/// characters; the end is the first that is not meant) and first, last (bytes from 0).
std::string to_json(const Diagnostic&, const SourceStore&);

/// What the scene says by #debug and its relatives, in the same form.
std::string debug_to_json(std::string_view text);

}  // namespace candelabra
