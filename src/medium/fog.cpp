// SPDX-License-Identifier: GPL-3.0-or-later
#include "medium/fog.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

const ItemInfo Fog::vocabulary = described<Fog>([] {
    using F = Field<Fog>;
    return schema<Fog>(
        "fog",
        {"Fog in the open, not inside of solids.", "fog { rgb 0.8, distance 20 }",
         "fog { fog_type 2 rgb 0.8, distance 4 fog_offset 0.2 fog_alt 0.4 up y turbulence 0.3 "
         "turb_depth 0.5 octaves 3 omega 0.5 lambda 2 }"},
        maybe(
            F{"colour", &Fog::colour, positional,
              "colour of the fog; filter tints what is behind, transmit is seen through any fog"}),
        maybe(F{"away", &Fog::distance, positional, "the distance, as old scenes write it",
                at_least(0)}),
        F{"fog_type", &Fog::fog_type, item,
          "1: constant density, 2: density that falls with height", between(1, 2)},
        F{"distance", &Fog::distance, item, "where 37 % of what is behind are left; 0: no fog",
          at_least(0)},
        F{"fog_offset", &Fog::fog_offset, item, "up to this height it has its full density"},
        F{"fog_alt", &Fog::fog_alt, item,
          "height above fog_offset at which the density is a half; below 0: beneath it"},
        F{"up", &Fog::up, item, "the direction in which heights are measured"},
        F{"turbulence", &Fog::turbulence, item, "how much it is disturbed along each axis"},
        F{"turb_depth", &Fog::turb_depth, item, "how strongly the disturbance counts"},
        F{"octaves", &Fog::octaves, item, "terms of the turbulence", between(1, 10)},
        F{"omega", &Fog::omega, item, "size of each octave over the one before"},
        F{"lambda", &Fog::lambda, item, "frequency of each octave over the one before"});
});

namespace {

/// Integral of the density over height, in units of fog_alt.
double column(double height) { return height <= 0 ? height : math::atan(height); }

double density(double height) { return height <= 0 ? 1 : 1 / (1 + height * height); }

/// Whether heights have no direction. Then POV-Ray's shares are no numbers, and its picture is
/// black.
bool is_black(const Fog& fog) { return fog.fog_type == 2 && fog.up == Vec3(0); }

/// Mean density along the ray up to a distance.
double mean_density(const Fog& fog, const Ray& ray, double distance) {
    if (fog.fog_type == 1) return 1;
    const Vec3 up = unit(fog.up);
    const auto height = [&](double along) {
        return (along - fog.fog_offset) / (fog.fog_alt == 0 ? 1e-10 : fog.fog_alt);
    };
    const double start = height(dot(ray.origin, up));
    const double rise = dot(ray.direction, up);
    // A very large distance is as good as an infinite one, and has a mean.
    const double end = height(dot(ray.origin, up) + std::min(distance, 1e7) * rise);
    if (std::abs(end - start) < 1e-9) return density(start);
    return (column(end) - column(start)) / (end - start);
}

/// Transmittance of the fog.
double share_left(const Fog& fog, const Ray& ray, double distance, NoiseGenerator generator) {
    double way = std::min(distance, 1e7);
    if (fog.turbulence != Vec3(0) && distance < 1e7) {
        const Vec3 middle = ray.at(0.5 * way) * fog.turbulence;
        const Octaves octaves{fog.octaves, static_cast<float>(fog.omega),
                              static_cast<float>(fog.lambda)};
        const double noise = scalar_turbulence(middle, octaves, generator) * fog.turb_depth;
        way *= 1 - math::exp(-way / fog.distance) * std::min(1.0, noise);
    }
    return std::max(math::exp(-way * mean_density(fog, ray, distance) / fog.distance),
                    fog.colour.transmit);
}

/// Transmittance coloured by the fog's filter.
Rgb tinted(const Fog& fog, double share) {
    return share * (Rgb(1 - fog.colour.filter) + fog.colour.filter * fog.colour.rgb);
}

}  // namespace

Rgb left_by(std::span<const Fog> fogs, const Ray& ray, double distance, NoiseGenerator generator) {
    Rgb all(1);
    for (const Fog& fog : fogs) {
        if (fog.distance <= 0) continue;
        if (is_black(fog)) return Rgb(0);
        all *= tinted(fog, share_left(fog, ray, distance, generator));
    }
    return all;
}

Veil veil_of(std::span<const Fog> fogs, const Ray& ray, double distance, NoiseGenerator generator) {
    Rgb own(0), behind(1);
    for (const Fog& fog : fogs) {
        if (fog.distance <= 0) continue;
        if (is_black(fog)) return {Rgb(0), Rgb(0)};
        const double share = share_left(fog, ray, distance, generator);
        own += (1 - share) * fog.colour.rgb;
        behind *= tinted(fog, share);
    }
    return {behind, own};
}

}  // namespace candelabra
