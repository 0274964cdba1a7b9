// SPDX-License-Identifier: GPL-3.0-or-later
// What shapes get from files and functions before they can be built: the letters of a text, the
// heights of a height field, the faces of a mesh; and usual values for those that cannot be meant.
// Called by the reader of objects when a shape's fields are known.
#pragma once

#include "bind/block.h"

namespace candelabra {

/// Loads the files that the shape needs. Faults are reported, and the block is broken then.
void complete(OpenBlock&, Shape&);

}  // namespace candelabra
