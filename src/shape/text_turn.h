// SPDX-License-Identifier: GPL-3.0-or-later
// The rotation that every text { } has before its own transformations.
#pragma once

#include "base/transform.h"

namespace candelabra {

/// As in POV-Ray, a tiny rotation keeps rays along the axes off the edges of letters.
inline Transform text_turn() { return Transform::rotation(Vec3(0.001)); }

}  // namespace candelabra
