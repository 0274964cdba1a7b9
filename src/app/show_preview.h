// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra relight FILE --preview PORT`: a page that plays a show, served to a browser.
#pragma once

#include "app/show_files.h"
#include "console/console.h"
#include "options/options.h"
#include "text/diagnostic.h"

#include <string>

namespace candelabra {

/// Serves the page of a show (see shared_show()) until the run is stopped. When one of its files
/// changes, it makes the page anew, and browsers load it; with a file that has an error the page
/// stays, and the error is said. Returns the exit status.
int preview_show(const std::string& lights, const ShowFiles&, const Options&, const Console&,
                 Diagnostics&);

}  // namespace candelabra
