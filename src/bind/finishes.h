// SPDX-License-Identifier: GPL-3.0-or-later
// finish and interior blocks. Called by the readers of textures, of objects and of #declare.
#pragma once

#include "bind/block.h"

namespace candelabra {

/// All change the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_finish(Binder&, const Element& block, Finish&);
/// The words of a finish in a texture from before version 3.0, whose word is at the span.
bool read_legacy_finish(Binder&, const ElementList&, Span, Finish&);
bool read_interior(Binder&, const Element& block, Interior&);

}  // namespace candelabra
