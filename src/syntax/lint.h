// SPDX-License-Identifier: GPL-3.0-or-later
// What is legal in a file and yet likely a mistake, as far as its text alone can tell. Called for
// the scene's own file, not for libraries.
#pragma once

#include "syntax/tree.h"
#include "text/diagnostic.h"

namespace candelabra {

/// Warns of parameters that a macro with a body does not name. Scoping is dynamic, so a macro that
/// is called may use them nevertheless; then the warning can be switched off.
void lint(const Tree&, const Names&, Diagnostics&);

}  // namespace candelabra
