// SPDX-License-Identifier: GPL-3.0-or-later
// Reads blocks that are parts of a shape: the spheres of a blob, the triangles of a mesh. Called by
// ItemReader for fields of that placement.
#pragma once

#include "bind/block.h"

namespace candelabra {

/// Adds the part that the element describes to the item, and its textures to the list of the block.
/// Reports errors and marks the block as broken.
void read_part(OpenBlock&, const FieldInfo&, void* item, const Element&);

}  // namespace candelabra
