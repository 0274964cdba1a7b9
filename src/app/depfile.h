// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture was made from, as a rule that make(1) and ninja read: with it they render again
// when the scene or anything that it reads has changed.
#pragma once

#include "app/identity.h"

#include <string>
#include <vector>

namespace candelabra {

/// "picture.png: scene.pov part.inc", each name as make wants it.
std::string depfile(const std::string& picture, const std::vector<ReadFile>&);

}  // namespace candelabra
