// SPDX-License-Identifier: GPL-3.0-or-later
// camera blocks. Called for the elements of a scene, for #declare and for #default.
#pragma once

#include "bind/bind.h"

namespace candelabra {

/// Changes the camera to what the block makes of it. False: the block was wrong, and has been
/// reported.
bool read_camera(Binder&, const Element& block, DeclaredCamera&);

}  // namespace candelabra
