// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra relight`: makes pictures of the light of each lamp that --keep-lights has kept, under
// other powers and colours of the lamps.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// `arguments`: those after `relight`. Returns the exit status.
int run_relight(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
