// SPDX-License-Identifier: GPL-3.0-or-later
// How much of a place's light the camera sees at most, through air that is the same throughout:
// what the straight way leaves. Light that goes by way of other places is dimmed more.
#pragma once

#include "transport/lit_region.h"

namespace candelabra {

class AirToCamera {
public:
    /// The region stands for a camera whose rays are parallel.
    AirToCamera(const Shot&, const LitRegion&);

    /// In the channel in which the air dims light least; 1 if there is no such air.
    double transmittance(const Vec3& place) const;

private:
    double extinction_ = 0;  ///< per unit of length
    Vec3 centre_ = Vec3(0);
    double radius_ = 0;  ///< of the ball around the centre in which nothing is dimmed
};

}  // namespace candelabra
