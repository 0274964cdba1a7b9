// SPDX-License-Identifier: GPL-3.0-or-later
// The lights of nested light groups.
#pragma once

#include "scene/scene.h"
#include "world/materials.h"

namespace candelabra {

/// Whether the lights of a union form a group of their own, to which its objects then belong.
bool opens_group(std::vector<LightGroup>&, const Union&, Inherited& here);

}  // namespace candelabra
