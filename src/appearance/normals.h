// SPDX-License-Identifier: GPL-3.0-or-later
// Reads normal, normal_map and slope_map blocks. Called by the readers of textures and of #declare.
#pragma once

#include "reading/block.h"

namespace candelabra {

/// These functions apply the block to the last argument. They return false, after a diagnostic, if
/// the block was wrong.
bool read_normal(Binder&, const Element& block, Bump&);
/// Reads a normal's words that stand directly in a texture, as before version 3.0; the span is that
/// of `texture`.
bool read_legacy_normal(Binder&, const ElementList&, Span, Bump&);
bool read_normal_map(Binder&, const Element& block, NormalMap&);
bool read_slope_map(Binder&, const Element& block, SlopeMap&);

/// Has the effect of `no_bump_scale` in the normal.
void keep_heights(Bump&);

}  // namespace candelabra
