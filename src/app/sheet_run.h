// SPDX-License-Identifier: GPL-3.0-or-later
// Renders the pictures of a contact sheet and joins them to one file. Called by the commands.
#pragma once

#include "console/console.h"
#include "options/sheet.h"

namespace candelabra {

/// Reports options that do not go together with a contact sheet.
void check_sheet(const Options&, Diagnostics&);

/// Renders the sheet that the options name. Reports errors and returns the exit status.
int run_sheet(const Options&, const Console&, Diagnostics&);

}  // namespace candelabra
