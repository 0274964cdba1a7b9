// SPDX-License-Identifier: GPL-3.0-or-later
// Reads material { }: how a surface and its inner side look, and what is inside. Used by the reader
// of objects and by declarations.
#pragma once

#include "bind/textures.h"

namespace candelabra {

/// Changes the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_material(Binder&, const Element& block, DeclaredMaterial&);

}  // namespace candelabra
