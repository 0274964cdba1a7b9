// SPDX-License-Identifier: GPL-3.0-or-later
// What is inside a solid: how it bends light, and how light fades and scatters there.
#pragma once

#include "medium/media.h"
#include "vocabulary/item_info.h"

namespace candelabra {

struct Interior {
    double ior = 0;            ///< 0: that of the air, and no dispersion
    double fade_distance = 0;  ///< 0: light is not dimmed
    double fade_power = 0;
    Vec3 fade_color = Vec3(0);
    double caustics = 0;    ///< strength of bright spots in shadows; 0: none
    double dispersion = 1;  ///< index of refraction at violet over that at red
    int dispersion_samples = 7;
    bool luminaire = false;         ///< what its media emit lights the scene
    std::vector<Media> media = {};  ///< all of them fill it

    static const ItemInfo vocabulary;
};

/// The interior after a transformation of the solid: only densities of media move.
Interior transformed(Interior, const Transform&);
/// Whether that makes a difference.
bool moves(const Interior&);

/// How fast bright spots fade with the angle, where caustics are 1. As in POV-Ray, where one of its
/// tables counts so.
constexpr double caustics_power = 45;

/// The share of light that is left after a distance inside, per channel. From a power of 1000 on it
/// falls exponentially, else by 1 / (1 + (distance / fade_distance)^fade_power).
Vec3 attenuation(const Interior&, double distance);

}  // namespace candelabra
