// SPDX-License-Identifier: GPL-3.0-or-later
// All items of the language in groups, for the manual, --help and editors. The only file that sees
// all kinds; it contains no logic. A new kind appears here automatically, a new variant of kinds
// needs one line.
#pragma once

#include "vocabulary/manual.h"

#include <span>

namespace candelabra {

std::span<const ItemGroup> catalogue();

}  // namespace candelabra
