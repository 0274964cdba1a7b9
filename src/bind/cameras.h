// SPDX-License-Identifier: GPL-3.0-or-later
// Reads camera blocks. Called for the elements of a scene, for #declare and for #default.
#pragma once

#include "reading/item_reader.h"

namespace candelabra {

/// Applies the block to the camera. Returns false, after a diagnostic, if the block was wrong.
bool read_camera(Binder&, const Element& block, DeclaredCamera&);

}  // namespace candelabra
