// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface answers light. Meanings and defaults are POV-Ray 3.7's.
#pragma once

#include "vocabulary/schema.h"

/// The block form of reflection: from straight on to grazing.
struct Reflection {
    Vec3 least = Vec3(0);     ///< seen straight on
    Vec3 greatest = Vec3(0);  ///< seen at grazing angles
    bool fresnel = false;
    double falloff = 1;
    double exponent = 1;
    double metallic = 0;

    static consteval auto vocabulary();
    friend bool operator==(const Reflection&, const Reflection&) = default;
};

consteval auto Reflection::vocabulary() {
    using F = Field<Reflection>;
    return schema<Reflection>(
        "reflection", "Mirror reflection, from straight on to grazing.",
        as_colour(F{"minimum", &Reflection::least, positional, "amount seen straight on"}),
        maybe(as_colour(F{"maximum", &Reflection::greatest, positional,
                          "amount at grazing angles; the minimum when left out"})),
        F{"fresnel", &Reflection::fresnel, flag,
          "amount by Fresnel's equations and the interior's ior"},
        F{"falloff", &Reflection::falloff, item, "exponent of the change with the angle"},
        F{"exponent", &Reflection::exponent, item, "dims dark reflections more than bright ones",
          above(0)},
        F{"metallic", &Reflection::metallic, item, "tints the reflection with the pigment"});
}

struct Finish {
    Vec3 ambient = Vec3(0.1);
    Vec3 emission = Vec3(0);
    double diffuse = 0.6;
    double brilliance = 1;
    double phong = 0;
    double phong_size = 40;
    double specular = 0;
    double roughness = 0.05;
    double metallic = 0;
    bool conserve_energy = false;
    Reflection reflection;

    static consteval auto vocabulary();
    friend bool operator==(const Finish&, const Finish&) = default;
};

consteval auto Finish::vocabulary() {
    using F = Field<Finish>;
    return schema<Finish>(
        "finish", "How a surface answers light.",
        as_colour(F{"ambient", &Finish::ambient, item,
                    "share of ambient_light that it seems to reflect everywhere"}),
        as_colour(F{"emission", &Finish::emission, item,
                    "radiance that it emits, times the pigment: makes it a luminaire"}),
        F{"diffuse", &Finish::diffuse, item,
          "share of the light that it scatters in all directions, times the pigment"},
        F{"brilliance", &Finish::brilliance, item,
          "exponent of the cosine of the light's angle in diffuse scattering", at_least(0)},
        F{"phong", &Finish::phong, item, "strength of the Phong highlight"},
        F{"phong_size", &Finish::phong_size, item,
          "exponent of the Phong highlight: greater is smaller", at_least(0)},
        F{"specular", &Finish::specular, item, "strength of the Blinn highlight"},
        F{"roughness", &Finish::roughness, item,
          "width of the Blinn highlight: its exponent is 1/roughness", above(0)},
        F{"metallic", &Finish::metallic, item,
          "tints highlights with the pigment; 1 when no number follows"},
        F{"conserve_energy", &Finish::conserve_energy, flag,
          "what is reflected does not also pass through"});
}
