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

/// Warns of a picture of this size that stretches what the camera sees by more than one part in
/// fifty. Nothing is said of the default camera, which review() warns of, of cameras without
/// pixel_aspect(), nor of pictures of less than 32 pixels.
void review_shape(const Scene&, int width, int height, Diagnostics&);

}  // namespace candelabra
