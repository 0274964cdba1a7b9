// SPDX-License-Identifier: GPL-3.0-or-later
// What the program does with its options: renders, checks, dumps, explains. Everything it says goes
// through the console.
#pragma once

#include "app/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// Does what the program's arguments (without its name) ask for; gives the exit status.
int run(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
