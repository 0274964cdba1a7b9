// SPDX-License-Identifier: GPL-3.0-or-later
// Transforms shapes that stay shapes of their kind. Called where objects are put together.
#pragma once

#include "base/transform.h"
#include "shape/plane.h"

namespace candelabra {

/// The plane under a map, with a unit normal.
Plane transformed(const Plane&, const Transform&);

}  // namespace candelabra
