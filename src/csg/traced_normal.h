// SPDX-License-Identifier: GPL-3.0-or-later
// The normals that trace() tells. POV-Ray's shapes have theirs on the side that is easiest to
// compute, and shading turns them to the eye: normals of curves are on the right of the direction
// in which they are drawn, those of prisms' ends upwards.
#pragma once

#include "shape/composite.h"

namespace candelabra {

/// The normal where the ray meets the leaf.
Vec3 traced_normal(const CompositeLeaf&, const Ray&, const Composite::Meeting&);

}  // namespace candelabra
