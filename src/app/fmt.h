// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra fmt`: formats scenes.
#pragma once

#include "console/console.h"

#include <span>
#include <string_view>

namespace candelabra {

/// Formats the files in place, or standard input to standard output if none are given. With
/// --check, only names the files that would change; the exit status is then that of an error in the
/// scene. Files with syntax errors are left unchanged.
int fmt(std::span<const std::string_view> arguments, const Console&);

}  // namespace candelabra
