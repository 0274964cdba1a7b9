// SPDX-License-Identifier: GPL-3.0-or-later
// Reads finish and interior blocks. Called by the readers of textures, of objects and of #declare.
#pragma once

#include "reading/block.h"

namespace candelabra {

/// These functions apply the block to the last argument. They return false, after a diagnostic, if
/// the block was wrong.
bool read_finish(Binder&, const Element& block, Finish&);
/// Reads a finish's words that stand directly in a texture, as before version 3.0; the span is that
/// of `texture`.
bool read_legacy_finish(Binder&, const ElementList&, Span, Finish&);
bool read_interior(Binder&, const Element& block, Interior&);

}  // namespace candelabra
