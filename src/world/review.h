// SPDX-License-Identifier: GPL-3.0-or-later
// What is legal in a scene and yet likely a mistake, seen when it is complete: one that nobody can
// see anything in. Called by the application before it renders.
#pragma once

#include "scene/scene.h"
#include "text/diagnostic.h"
#include "world/world.h"

namespace candelabra {

/// Warns of a scene without a camera, without objects, or that nothing lights, of a camera that is
/// in an object, and of finishes whose light below the surface the scene does not ask for; of the
/// last only with a compiled world. The world is the scene's.
void review(const Scene&, const World&, Diagnostics&);

}  // namespace candelabra
