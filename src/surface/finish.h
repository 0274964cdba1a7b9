// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface answers light. Meanings and defaults are POV-Ray 3.7's.
#pragma once

#include "surface/subsurface.h"

namespace candelabra {

/// The block form of reflection: from straight on to grazing.
struct Reflection {
    Vec3 least = Vec3(0);     ///< seen straight on
    Vec3 greatest = Vec3(0);  ///< seen at grazing angles
    bool fresnel = false;
    double falloff = 1;
    double exponent = 1;
    double metallic = 0;

    static const ItemInfo vocabulary;
    friend bool operator==(const Reflection&, const Reflection&) = default;
};

/// Colours as of a film of oil: by interference, at the angles of light and view.
struct Irid {
    double amount = 0;  ///< 0: none
    double thickness = 0;
    double turbulence = 0;

    static const ItemInfo vocabulary;
    friend bool operator==(const Irid&, const Irid&) = default;
};

/// How much light a surface of small facets scatters: the material of today's programs. The pigment
/// is its base colour; it takes the place of diffuse, phong and specular.
struct Microfacet {
    double roughness = 0.5;  ///< the facets' directions vary by its square
    double metallic = 0;     ///< 1: all is reflected, with the base colour
    double specular = 0.5;   ///< of what is no metal: 8 % of this are reflected straight on
    double coat = 0;         ///< of a clear layer above, as of lacquer
    double coat_roughness = 0.03;
    bool on = false;

    static const ItemInfo vocabulary;
    friend bool operator==(const Microfacet&, const Microfacet&) = default;
};

struct Finish {
    Vec3 ambient = Vec3(0.1);
    Vec3 emission = Vec3(0);
    bool no_luminaire = false;  ///< the emission makes no luminaire
    double diffuse = 0.6;
    double diffuse_back = 0;  ///< for light that comes from behind
    double brilliance = 1;
    double phong = 0;
    double phong_size = 40;
    double specular = 0;
    double roughness = 0.05;
    double crand = 0;
    double metallic = 0;
    bool conserve_energy = false;
    double ior = 0;  ///< instead of the interior's; 0: not
    /// Of the top layer, instead of the interior's: an exponent; below 0: not.
    double caustics = -1;
    double refraction = 1;  ///< share of what is seen through it
    Reflection reflection;
    Irid irid;
    Microfacet microfacet;
    Subsurface subsurface;

    static const ItemInfo vocabulary;
    friend bool operator==(const Finish&, const Finish&) = default;
};

}  // namespace candelabra
