// SPDX-License-Identifier: GPL-3.0-or-later
// Reads blocks that are parts of a shape: the spheres of a blob, the triangles of a mesh. Called by
// ItemReader for fields of that placement.
#pragma once

#include "reading/block.h"

namespace candelabra {

/// Reads the looks of the parts of one shape, one part after the other. It belongs to the object
/// around them, because textures are read in a room after this one.
class PartLooks {
public:
    virtual ~PartLooks() = default;
    /// Begins a part, whose block outlives the reading of it.
    virtual void begin(OpenBlock& part) = 0;
    /// Takes a texture, pigment, normal, finish or texture_list of the part.
    virtual bool take(const Element&) = 0;
    /// Moves what the part has been given so far.
    virtual void move(const Transform&) = 0;
    /// Ends the part: stores the indices of its textures in the list of the shape, or -1.
    virtual void number(int* looks, int count) = 0;
};

/// Adds the part that the element describes to the item, and its textures to the looks of the
/// block. Reports errors and marks the block as broken.
void read_part(OpenBlock&, const FieldInfo&, void* item, const Element&);

}  // namespace candelabra
