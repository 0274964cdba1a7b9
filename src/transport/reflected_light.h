// SPDX-License-Identifier: GPL-3.0-or-later
// Light at a vertex from reflected luminaires.
#pragma once

#include "base/rgb.h"
#include "transport/arrival.h"
#include "transport/reflected_luminaires.h"

#include <optional>

namespace candelabra {

/// Each job has its own.
class ReflectedLight : public ServedGeneration<ReflectedLuminaires> {
public:
    using ServedGeneration::ServedGeneration;

    /// The light that counts.
    struct Counted {
        int reflections;  ///< after which it arrives, at most
        /// Scattering of light that a medium without `multiple` has scattered before; null: such
        /// light does not count.
        std::optional<Scatterer> of_scattered = {};
        int rays = 1;  ///< number of shadow rays
    };
    /// Radiance towards the viewer from a Lambertian layer or a place in a medium, by light that
    /// arrives there by way of diffuse surfaces and media only, with the geometry term clamped to
    /// its bound.
    Rgb operator()(const ArrivingLight&, const Counted&, const Key&);

    /// Whether they stand for light that media scatter, too, and light media.
    bool in_air() const { return *this && source().in_air(); }

    /// Fraction of the light from a place of one surface, on the side of the unit normal, to
    /// another that comes from reflected luminaires, given the cosines to their normals and the
    /// distance. The cosine at a place in a medium is 1.
    double share(const Vec3& from, const Vec3& normal, double cosine, double other_cosine,
                 double distance) const;
    /// The same from a place in a medium.
    double share_in_air(const Vec3& from, double other_cosine, double distance) const;

private:
    Rgb from(const LightPick&, const ReflectedSet&, const ArrivingLight&, const Scatterer&,
             const Key&) const;

    LightSamples samples_;  ///< kept as a member to reuse its memory
};

}  // namespace candelabra
