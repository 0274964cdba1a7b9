// SPDX-License-Identifier: GPL-3.0-or-later
// normal, normal_map and slope_map blocks. Called by the readers of textures and of #declare.
#pragma once

#include "bind/block.h"

namespace candelabra {

/// All change the last argument to what the block makes of it. False: the block was wrong, and has
/// been reported.
bool read_normal(Binder&, const Element& block, Bump&);
/// The words of a normal in a texture from before version 3.0, whose word is at the span.
bool read_legacy_normal(Binder&, const ElementList&, Span, Bump&);
bool read_normal_map(Binder&, const Element& block, NormalMap&);
bool read_slope_map(Binder&, const Element& block, SlopeMap&);

/// As if the normal had said `no_bump_scale`.
void keep_heights(Bump&);

}  // namespace candelabra
