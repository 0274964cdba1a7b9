// SPDX-License-Identifier: GPL-3.0-or-later
// Which objects are quickly seen to be no luminaires: nearly all of most scenes. Called by
// flatten() where nothing else is wanted of them.
#pragma once

#include "scene/scene.h"

namespace candelabra {

/// Whether no part of the object can emit light: false also where that takes a closer look.
/// `inherited` is the texture of parts that have none of their own; null: none.
bool cannot_emit(const Object&, const Handle<Texture>* inherited);

}  // namespace candelabra
