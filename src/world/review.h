// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of legal scenes that are likely mistakes, for example if nothing can be seen. Called by
// the application before it renders.
#pragma once

#include "scene/scene.h"
#include "text/diagnostic.h"
#include "world/world.h"

namespace candelabra {

/// Warns of a scene without camera, objects or light, of a camera inside of an object, and of
/// settings without effect, such as subsurface finishes that the scene does not enable; of the
/// latter only with a compiled world. The world must be that of the scene.
void review(const Scene&, const World&, Diagnostics&);

}  // namespace candelabra
