// SPDX-License-Identifier: GPL-3.0-or-later
// Reads material { }: the textures of a surface and of its inner side, and the interior. Used by
// the reader of objects and by declarations.
#pragma once

#include "appearance/textures.h"

namespace candelabra {

/// Applies the block to the last argument. Returns false, after a diagnostic, if the block was
/// wrong.
bool read_material(Binder&, const Element& block, DeclaredMaterial&);

}  // namespace candelabra
