// SPDX-License-Identifier: GPL-3.0-or-later
// Completes shapes that need files or functions: the letters of a text, the heights of a height
// field, the faces of a mesh. Replaces nonsensical values by the defaults. Called by the reader of
// objects when a shape's fields are known.
#pragma once

#include "reading/block.h"

namespace candelabra {

/// Loads the files that the shape needs. On failure, reports it and marks the block as broken.
void complete(OpenBlock&, Shape&);

}  // namespace candelabra
