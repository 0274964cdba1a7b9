// SPDX-License-Identifier: GPL-3.0-or-later
// A textual description of a compiled world and its index, for --dump world. Depends on the scene
// only.
#pragma once

#include "world/world.h"

#include <string>

namespace candelabra {

std::string report(const World&);

}  // namespace candelabra
