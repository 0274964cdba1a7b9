// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Formats a diagnostic for display: message, place, the source lines with carets below them, the
// path to the place, help. Called by the application and by tests. Computes lines and columns, and
// makes any bytes safe to print. The text ends in a newline.

#include "text/diagnostic.h"
#include "text/source.h"

#include <string>

namespace candelabra {

std::string format(const Diagnostic& diagnostic, const SourceStore& sources, bool coloured);

}  // namespace candelabra
