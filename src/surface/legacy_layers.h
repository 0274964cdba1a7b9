// SPDX-License-Identifier: GPL-3.0-or-later
// Layered textures in scenes of version 3.1 and before. Called where layers are joined.
#pragma once

#include "surface/texture.h"

namespace candelabra {

/// Returns the texture with the filter of its pigments turned into transmit, so that the layers
/// below show through in their own colours.
Texture with_filter_as_transmit(Texture);

}  // namespace candelabra
