// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra develop`: pictures that people look at, of the light that OpenEXR files have kept.
#pragma once

#include "app/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// The arguments behind `develop`. Gives the exit status.
int run_develop(std::span<const std::string_view> arguments, const Console&);

/// The same of one OpenEXR file, by the film that it tells of. An empty layer is the picture
/// itself. False after a report.
bool develop_file(const std::string& exr, std::string_view layer, const std::string& picture,
                  Diagnostics&);

}  // namespace candelabra
