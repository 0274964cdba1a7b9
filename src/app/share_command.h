// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra share`: a page with a picture whose lamps can be mixed anew, of a scene or of an
// OpenEXR file with the light of its lamps; or of a file that keeps the light of many, with a show.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// `arguments`: those after `share`. Returns the exit status.
int run_share(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
