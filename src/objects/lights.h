// SPDX-License-Identifier: GPL-3.0-or-later
// Reads light_source blocks. Called for the elements of a scene, for #declare, and by the readers
// of objects.
#pragma once

#include "reading/item_reader.h"
#include "scene/scene.h"

namespace candelabra {

/// Whether the block is a `light_source` that begins with the name of an object, which may contain
/// lights. It is read as an `object` then, as in POV-Ray.
bool is_lamp(const Binder&, const Element& block);

/// Returns nothing after a diagnostic.
std::optional<PlacedLight> read_light(Binder&, const Element& block);

}  // namespace candelabra
