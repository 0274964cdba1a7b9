// SPDX-License-Identifier: GPL-3.0-or-later
// A compiled world in words, for --dump world: what it is made of and how it is arranged. Depends
// on the scene only.
#pragma once

#include "world/world.h"

#include <string>

namespace candelabra {

std::string report(const World&);

}  // namespace candelabra
