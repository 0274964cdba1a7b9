// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the pictures of a contact sheet and joins them to one file. Called by the commands.
#pragma once

#include "console/console.h"
#include "options/sheet.h"

#include <optional>

namespace candelabra {

/// Returns the contact sheet that the options name, if any. Reports errors in it, and options that
/// do not go together with it.
std::optional<Sheet> plan_sheet(const Options&, Diagnostics&);

/// Renders the sheet. Reports errors and returns the exit status.
int run_sheet(const Options&, const Sheet&, const Console&, Diagnostics&);

}  // namespace candelabra
