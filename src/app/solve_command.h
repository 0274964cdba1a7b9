// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra solve`: finds powers of lamps with which the meters of a scene read what they are to.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// `arguments`: those after `solve`. Returns the exit status.
int run_solve(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
