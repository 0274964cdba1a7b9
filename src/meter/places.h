// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a meter.
#pragma once

#include "meter/meter.h"

#include <cstddef>
#include <vector>

namespace candelabra {

struct MeterPlace {
    Vec3 position;
    Vec3 direction;  ///< unit: where the plane faces, or the observer looks
};

/// Numbers of the points of a grid.
struct GridCounts {
    std::size_t along = 1, across = 1;
};

/// Points by EN 12464-1 of an area with sides of these lengths in metres: their distance is at most
/// about 0.2 * 5^log10(d), d being the longer side, or the shorter one of a strip.
GridCounts points_by_en_12464(double along, double across);
/// Points by EN 13201-3 of a field of road, of which `along` lies between two lamps, in metres.
/// Three a lane count for luminance; `lanes` is 0 for illuminance.
GridCounts points_by_en_13201(double along, double across, int lanes);

/// The numbers of the meter's grid; `metres`: of a unit of length. Precondition: it has a grid.
GridCounts counts_of(const Meter&, double metres);

/// The points, which are no more than most_meter_places; all of the first row along, then the next
/// one. Empty if they would be more. Precondition: the meter has no problem.
std::vector<MeterPlace> places_of(const Meter&, double metres);
inline constexpr std::size_t most_meter_places = 1'000'000;

}  // namespace candelabra
