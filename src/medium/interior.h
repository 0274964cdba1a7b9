// SPDX-License-Identifier: GPL-3.0-or-later
// The interior of a solid: how it refracts light, and how light fades and scatters there.
#pragma once

#include "base/rgb.h"
#include "medium/media.h"
#include "vocabulary/item_info.h"

namespace candelabra {

struct Interior {
    double ior = 0;            ///< 0: index of the air, and no dispersion
    double fade_distance = 0;  ///< 0: no attenuation
    double fade_power = 0;
    Rgb fade_color = Rgb(0);
    double caustics = 0;    ///< strength of bright spots in shadows; 0: none
    double dispersion = 1;  ///< ratio of the refractive indices of violet and red
    int dispersion_samples = 7;
    bool luminaire = false;         ///< whether the emission of its media lights the scene
    std::vector<Media> media = {};  ///< they fill the interior together

    static const ItemInfo vocabulary;
};

/// Returns the interior after a transformation of the solid; only densities of media change.
Interior transformed(Interior, const Transform&);
/// Whether a transformation changes the interior.
bool moves(const Interior&);

/// Exponent by which bright spots fade with the angle if `caustics` is 1. The same as in POV-Ray,
/// where it is an entry of a table.
constexpr double caustics_power = 45;

/// Transmittance of a distance inside, per channel. From a fade_power of 1000 on it falls
/// exponentially, else as 1 / (1 + (distance / fade_distance)^fade_power).
Rgb attenuation(const Interior&, double distance);

}  // namespace candelabra
