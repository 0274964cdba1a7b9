// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface responds to light. Meanings and defaults are POV-Ray 3.7's.
#pragma once

#include "base/handle.h"
#include "base/rgb.h"
#include "surface/lamp_data.h"
#include "surface/subsurface.h"

namespace candelabra {

/// The block form of reflection, which changes from normal to grazing incidence.
struct Reflection {
    Rgb least = Rgb(0);     ///< at normal incidence
    Rgb greatest = Rgb(0);  ///< at grazing angles
    bool fresnel = false;
    double falloff = 1;
    double exponent = 1;
    double metallic = 0;

    static const ItemInfo vocabulary;
    friend bool operator==(const Reflection&, const Reflection&) = default;
};

/// Colours of a film of oil: interference that depends on the angles of light and view.
struct Irid {
    double amount = 0;  ///< 0: none
    double thickness = 0;
    double turbulence = 0;

    static const ItemInfo vocabulary;
    friend bool operator==(const Irid&, const Irid&) = default;
};

/// A microfacet material, as in today's modelling programs. The pigment is its base colour; it
/// replaces diffuse, phong and specular.
struct Microfacet {
    double roughness = 0.5;  ///< its square is the width of the facets' distribution
    double metallic = 0;     ///< 1: reflects all light, tinted with the base colour
    double specular = 0.5;   ///< of the non-metallic part, which reflects 8 % of this at normal
                             ///< incidence
    double coat = 0;         ///< strength of a clear coat, such as lacquer
    double coat_roughness = 0.03;
    bool on = false;

    static const ItemInfo vocabulary;
    friend bool operator==(const Microfacet&, const Microfacet&) = default;
};

struct Finish {
    Rgb ambient = Rgb(0.1);
    Rgb emission = Rgb(0);
    /// States the flux of each object that shows the finish; null: nothing is stated.
    Handle<LampData> lamp = {};
    bool no_luminaire = false;  ///< its emission is not a luminaire
    double diffuse = 0.6;
    double diffuse_back = 0;  ///< for light from behind
    double brilliance = 1;
    double phong = 0;
    double phong_size = 40;
    double specular = 0;
    double roughness = 0.05;
    double crand = 0;
    double metallic = 0;
    bool conserve_energy = false;
    bool use_alpha = false;  ///< where it is clear, it reflects and shines less
    double ior = 0;  ///< replaces the interior's index; 0: unset
    /// For the top layer, an exponent that replaces the interior's caustics; below 0: unset.
    double caustics = -1;
    double refraction = 1;  ///< fraction of the light from behind that shows through
    Reflection reflection;
    Irid irid;
    Microfacet microfacet;
    Subsurface subsurface;

    static const ItemInfo vocabulary;
    friend bool operator==(const Finish&, const Finish&) = default;
};

}  // namespace candelabra
