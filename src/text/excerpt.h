// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A diagnostic as text for people: message, place, the lines concerned with carets below them, how
// the place was reached, help. Called by the application and by tests; computes lines and columns,
// and shows any bytes harmlessly. The text ends in a newline.

#include "text/diagnostic.h"
#include "text/source.h"

#include <string>

namespace candelabra {

std::string format(const Diagnostic& diagnostic, const SourceStore& sources, bool coloured);

}  // namespace candelabra
