// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of textures as scenes of version 3.1 and before mean them. Called where layers are joined.
#pragma once

#include "surface/texture.h"

namespace candelabra {

/// The texture with all filter of its pigments as transmit: what lies under it shows through in its
/// own colours.
Texture with_filter_as_transmit(Texture);

}  // namespace candelabra
