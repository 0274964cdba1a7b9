// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of legal text that is likely a mistake, as far as the text alone can tell. They are for
// the scene's own file, not for libraries.
#pragma once

#include "syntax/tree.h"
#include "text/diagnostic.h"

namespace candelabra {

/// Warns of parameters that a macro with a body does not name. Scoping is dynamic, so a macro that
/// it calls may still use them; then the warning can be switched off.
void lint(const Tree&, const Names&, Diagnostics&);

}  // namespace candelabra
