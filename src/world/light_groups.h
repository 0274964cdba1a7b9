// SPDX-License-Identifier: GPL-3.0-or-later
// Which lights light the objects of light groups that are in each other.
#pragma once

#include "scene/scene.h"
#include "world/materials.h"

namespace candelabra {

/// Whether the lights of a union are a group of their own, which its objects then belong to.
bool opens_group(std::vector<LightGroup>&, const Union&, Inherited& here);

}  // namespace candelabra
