// SPDX-License-Identifier: GPL-3.0-or-later
// The normals that trace() returns. POV-Ray's shapes have them on the side that is easiest to
// compute, and shading turns them to the eye: normals of curves are on the right of their drawing
// direction, those of prisms' ends point upwards.
#pragma once

#include "shape/composite.h"

namespace candelabra {

/// The normal where the ray hits the leaf.
Vec3 traced_normal(const CompositeLeaf&, const Ray&, const Composite::Meeting&);

}  // namespace candelabra
