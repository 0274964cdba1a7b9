// SPDX-License-Identifier: GPL-3.0-or-later
// What the numbers of a scene are in the units of photometry. Two constants say it all: how long a
// unit of the scene is, and which luminance a radiance of 1 stands for.
#pragma once

#include "vocabulary/item_info.h"

#include <numbers>
#include <optional>

namespace candelabra {

/// Of `photometry { ... }` in global_settings.
struct PhotometricUnits {
    std::optional<double> unit;  ///< metres of a unit of length; unset: as mm_per_unit says
    double white = 200;          ///< candela per square metre of a radiance of 1

    static const ItemInfo vocabulary;
    friend bool operator==(const PhotometricUnits&, const PhotometricUnits&) = default;
};

/// Conversions between photometric quantities and the numbers of a scene.
struct LightUnits {
    double metres = 0.01;  ///< of a unit of length
    double white = 200;    ///< see PhotometricUnits

    /// Radiance of a luminance in cd/m2.
    double radiance(double nits) const { return nits / white; }
    /// Colour of a light source that gives an illuminance in lux where it falls perpendicularly.
    double colour(double lux) const { return lux / (std::numbers::pi * white); }
    /// Colour at a distance of 1 of a light source with that luminous intensity in candela, which
    /// falls with the square of the distance.
    double intensity(double candela) const { return colour(candela) / (metres * metres); }
    /// Radiance times area of a surface that emits that flux in lumens, the same in all directions.
    double flux(double lumens) const { return colour(lumens) / (metres * metres); }

    /// Luminance in cd/m2 of a radiance.
    double luminance(double radiance) const { return radiance * white; }
    /// Flux in lumens of a radiance times area.
    double lumens(double flux) const { return flux * std::numbers::pi * white * metres * metres; }

    friend bool operator==(const LightUnits&, const LightUnits&) = default;
};

}  // namespace candelabra
