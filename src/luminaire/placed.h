// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires of instances: they are stored once, in the space of the instances' prototype, and each
// is made in its place when it is asked.
#pragma once

#include "luminaire/luminaire.h"

namespace candelabra {

/// Whether placed() makes the luminaire quickly: a sphere, triangle, rectangle or area that emits
/// alike everywhere and in all directions.
bool can_be_placed(const Luminaire&);

/// The luminaire in another place, with the radiance that it has. Precondition: can_be_placed();
/// the transform is a similarity.
Luminaire placed(const Luminaire&, const Transform&);

}  // namespace candelabra
