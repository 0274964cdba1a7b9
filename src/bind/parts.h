// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks within the block of a shape, which are parts of it: the spheres of a blob, the triangles
// of a mesh. Called by the ItemReader for fields of that placement.
#pragma once

#include "bind/block.h"

namespace candelabra {

/// Adds the part that the element describes to the item. Its textures go to the list of the block.
/// What is wrong is reported, and the block is broken then.
void read_part(OpenBlock&, const FieldInfo&, void* item, const Element&);

}  // namespace candelabra
