// SPDX-License-Identifier: GPL-3.0-or-later
// Points all over a surface, at random and yet nowhere close together: places for lamps, leaves,
// studs. What the language's scatter() gives.
#pragma once

#include "shape/area.h"
#include "shape/composite.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// Points of the seen surface that are at least so far from each other, so many that hardly one
/// more finds room (Poisson-disc sampling by throwing darts); with unit normals as rays meet them.
/// They lie on the surface itself; 0.9 times the area over distance^2 is a bound of their number.
/// `triangles` are near it: see seen_tessellation(). The same for the same seed.
std::vector<SurfacePoint> scattered(const Composite&, const Mesh& triangles, double distance,
                                    std::uint64_t seed);

}  // namespace candelabra
