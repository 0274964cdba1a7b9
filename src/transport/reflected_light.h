// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex from reflected luminaires.
#pragma once

#include "base/rgb.h"
#include "transport/arrival.h"
#include "transport/reflected_luminaires.h"

namespace candelabra {

/// Each job has its own.
class ReflectedLight : public ServedGeneration<ReflectedLuminaires> {
public:
    using ServedGeneration::ServedGeneration;

    /// Radiance towards the viewer from a Lambertian layer, by light that arrives there after at
    /// most `reflections` reflections, by way of diffuse surfaces only, with the geometry term
    /// clamped to its bound.
    Rgb operator()(const ArrivingLight&, int reflections, const Key&);

    /// Fraction of the light from a place of one surface, on the side of the unit normal, to
    /// another that comes from reflected luminaires, given the cosines to their normals and the
    /// distance.
    double share(const Vec3& from, const Vec3& normal, double cosine, double other_cosine,
                 double distance) const;

private:
    Rgb from(const LightPick&, const ReflectedSet&, const ArrivingLight&, const Key&) const;

    LightSamples samples_;  ///< kept as a member to reuse its memory
};

}  // namespace candelabra
