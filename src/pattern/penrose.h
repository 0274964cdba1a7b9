// SPDX-License-Identifier: GPL-3.0-or-later
// Penrose's three tilings of the plane: without period, and with five-fold symmetry around the
// origin. The value distinguishes kinds of tiles and falls from their borders inwards, 0..1.
#pragma once

#include "base/vector.h"

namespace candelabra {

/// Pentagons with sides of length 1 of three kinds, stars, boats and rhombs.
double penrose_pentagons(const Vec2&);

/// Kites and darts whose long sides have length 1.
double penrose_kites(const Vec2&);

/// Thick and thin rhombs with sides of length 1.
double penrose_rhombs(const Vec2&);

}  // namespace candelabra
