// SPDX-License-Identifier: GPL-3.0-or-later
// A ray that leaves a surface whose radiance is the same in all directions. Used by the emitters
// that sample points by area.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

/// Returns a ray from a point that was drawn with the density `per_area`. Its direction is drawn in
/// proportion to the cosine to the unit normal, on the normal's side or, with probability `inner`,
/// on the other one.
EmittedRay emitted_ray(const Vec3& position, const Vec3& normal, double per_area, double inner,
                       const EmissionDraw&);

/// The fraction of the rays of a face that leave its inner side, if `inner` is that of rays that
/// stay in the mesh around it; half of them if there is none.
double inner_share(SealedSide, double inner);

}  // namespace candelabra
