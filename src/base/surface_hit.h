// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ray meets a surface: the answer of single objects to the language.
#pragma once

#include "base/vector.h"

namespace candelabra {

struct SurfaceHit {
    Vec3 position;
    Vec3 normal;  ///< unit; not turned to where the ray comes from
};

}  // namespace candelabra
