// SPDX-License-Identifier: GPL-3.0-or-later
// Every item of the language, in groups: what the manual, --help and editors are told. The only
// file that sees all kinds; it holds no logic. A new kind appears here by itself, a new variant of
// kinds by one line.
#pragma once

#include "vocabulary/manual.h"

#include <span>

namespace candelabra {

std::span<const ItemGroup> catalogue();

}  // namespace candelabra
