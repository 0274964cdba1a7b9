// SPDX-License-Identifier: GPL-3.0-or-later
// Light of the sky at a layer, from directions that are drawn either where the sky is bright or
// where the layer responds strongly.
#pragma once

#include "base/rgb.h"
#include "transport/shadow_ray.h"

#include <optional>

namespace candelabra {

class SkyAtLayer {
public:
    SkyAtLayer(const ArrivingLight& at, const Key& key) : at_(at), key_(key) {}

    /// Draws a unit direction; nothing if the layer does not scatter to it.
    std::optional<Vec3> draw() const;
    /// Density of draw() per steradian: that of both ways together.
    double density(const Vec3& direction) const;

    /// Fraction of the light from a direction that is left at the layer, and the number of rays
    /// that found it and that count for the sky.
    struct Left {
        Rgb left;
        std::uint64_t rays;
    };
    /// Radiance towards the viewer from a unit direction, times a weight (see Arrival). A shadow
    /// ray finds what is left of the light, if it is not known.
    Rgb from(const Vec3& direction, const Rgb& weight) const;
    Rgb from(const Vec3& direction, const Rgb& weight, const Left&) const;

private:
    const ArrivingLight& at_;
    Key key_;
};

}  // namespace candelabra
