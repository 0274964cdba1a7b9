// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra develop`: makes pictures for display from the radiance in OpenEXR files.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// `arguments`: those after `develop`. Returns the exit status.
int run_develop(std::span<const std::string_view> arguments, const Console&);

/// Develops one OpenEXR file with the film that it records. An empty layer is the picture itself.
/// Returns false after an error has been reported.
bool develop_file(const std::string& exr, std::string_view layer, const std::string& picture,
                  Diagnostics&);

/// Finds problems with the movie, if the options want one, before the long work begins.
void check_movie(const Options&, Diagnostics&);

/// Warns of each option that was given and means the rendering of a picture.
void warn_of_options_of_rendering(const Options&, Diagnostics&);

}  // namespace candelabra
