// SPDX-License-Identifier: GPL-3.0-or-later
// Random points all over a surface, with a minimum distance from each other, to place lamps, leaves
// or studs. Result of the language's scatter().
#pragma once

#include "shape/area.h"
#include "shape/composite.h"

#include <cstdint>
#include <vector>

namespace candelabra {

/// Points of the visible surface with at least the given distance from each other, so dense that
/// hardly any more fit (Poisson-disc sampling by dart throwing), with the unit normals that rays
/// find. They lie on the surface itself; their number is at most 0.9 times the area over
/// distance^2. `triangles` approximate the surface: see seen_tessellation(). Deterministic for a
/// seed.
std::vector<SurfacePoint> scattered(const Composite&, const Mesh& triangles, double distance,
                                    std::uint64_t seed);

}  // namespace candelabra
