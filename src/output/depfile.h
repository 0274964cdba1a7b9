// SPDX-License-Identifier: GPL-3.0-or-later
// Dependencies of a picture as a rule for make(1) and ninja, which render again when the scene or a
// file that it reads has changed.
#pragma once

#include "session/read_files.h"

#include <string>
#include <vector>

namespace candelabra {

/// Returns the first name that no rule of make can have, or "": make would obey it.
std::string unnameable_in_depfile(const std::string& picture, const std::vector<ReadFile>&);

/// Returns "picture.png: scene.pov part.inc", with each name escaped for make. Precondition: none
/// is unnameable.
std::string depfile(const std::string& picture, const std::vector<ReadFile>&);

}  // namespace candelabra
