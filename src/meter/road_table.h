// SPDX-License-Identifier: GPL-3.0-or-later
// How a road reflects the light of lamps towards a driver, as standards tabulate it: the reduced
// luminance coefficient r of CIE 144, for an observer who looks one degree down.
#pragma once

#include "base/vector.h"

#include <string>
#include <vector>

namespace candelabra {

struct RoadTable {
    std::vector<double> tangents;  ///< of the angle of incidence; rising
    /// Beta in degrees, rising from 0 or more to at most 180: between the planes of sight and of
    /// incidence, 0 for light that comes from ahead of the observer.
    std::vector<double> angles;
    /// 10^4 r of all angles for the first tangent, then for the next; r is the luminance
    /// coefficient times the cube of the cosine of the angle of incidence.
    std::vector<double> entries;

    /// The luminance coefficient, in 1/sr: the luminance that an observer sees per illuminance of
    /// the road. Bilinear in the table; 0 for light that is more grazing than the last tangent, or
    /// from below. Unit vectors: `up` of the road, `sight` from the observer, `light` to the lamp.
    double coefficient(const Vec3& up, const Vec3& sight, const Vec3& light) const;
    friend bool operator==(const RoadTable&, const RoadTable&) = default;
};

/// Returns a sentence about an error in the table; empty if there is none.
std::string problem(const RoadTable&);

}  // namespace candelabra
