// SPDX-License-Identifier: GPL-3.0-or-later
// A quick test for objects that are not luminaires: nearly all objects of most scenes. Called by
// flatten() when only luminaires are wanted.
#pragma once

#include "scene/scene.h"

namespace candelabra {

/// Whether no part of the object can emit light. Also false if a closer look would be needed.
/// `inherited` is the texture of parts without one of their own; null: none.
bool cannot_emit(const Object&, const Handle<Texture>* inherited);

/// Whether a texture of the object emits light somewhere.
bool emits(const Object&, const Handle<Texture>* inherited);

}  // namespace candelabra
