// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra fmt`: scenes in the program's own hand.
#pragma once

#include "app/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// Lays out the files in place, or standard input to standard output when there are none; with
/// --check only names those that would change, and the status is that of an error in the scene.
/// Files with mistakes of syntax are left as they are.
int fmt(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
