// SPDX-License-Identifier: GPL-3.0-or-later
// Participating media: what absorbs, emits and scatters light between surfaces, in the interior of
// a solid or everywhere outside. POV-Ray 3.7's meaning: coefficients per unit of length of the
// scene, however the solid is scaled; isotropic scattering of colour 1 along one unit of length
// sends all of the light's colour to the viewer, without a factor of 1 / (4 pi).
#pragma once

#include "surface/pigment.h"
#include "vocabulary/item_info.h"

#include <span>
#include <string>
#include <vector>

namespace candelabra {

/// The phase functions by POV-Ray's numbers. A number that is none of them acts as isotropic.
enum class PhaseKind : int { isotropic = 1, mie_haze, mie_murky, rayleigh, henyey_greenstein };

/// How a medium scatters light.
struct Scattering {
    int type = 1;             ///< see PhaseKind
    Vec3 colour = Vec3(0);    ///< scattering coefficient, per unit of length; any sign
    double extinction = 1;    ///< share of what is scattered that the ray behind it lacks; any sign
    double eccentricity = 0;  ///< of type 5: above 0 light goes on forward
    bool multiple = false;    ///< light is scattered again and again, where paths are traced

    static const ItemInfo vocabulary;
};

/// The phase function times 4 pi: 1 of isotropic scattering. `cosine` is that of the angle between
/// the direction of the view and the one to the light: 1 looks into the light. Types 2, 3 and 4
/// have POV-Ray's constants, whose means over the sphere are 1.153, 1.247 and 1.066.
double phase(const Scattering&, double cosine);

/// One medium. Its density is the product of all its densities, channel by channel, and multiplies
/// all three coefficients.
struct Media {
    Vec3 absorption = Vec3(0);  ///< per unit of length; any sign
    Vec3 emission = Vec3(0);    ///< radiance per unit of length; any sign
    Scattering scattering;
    std::vector<Pigment> densities;  ///< in the space around the medium; none: 1 everywhere
    // Of POV-Ray's ways of sampling. They say how much effort is worth it, and not what is seen.
    int method = 3;
    int intervals = 1;
    int samples = 10;
    int max_samples = 0;  ///< what is below `samples` counts as that
    int aa_level = 3;
    double aa_threshold = 0.1;
    double confidence = 0.9;
    double variance = 1.0 / 128;
    double ratio = 0.9;
    double jitter = 0;
    bool collect = true;
    /// What it emits is counted as that of a luminaire; set where a world is made.
    bool luminaire = false;

    static const ItemInfo vocabulary;

    bool scatters() const { return scattering.colour != Vec3(0); }
    /// What it takes of light where its density is 1, per unit of length.
    Vec3 extinction() const { return absorption + scattering.extinction * scattering.colour; }
    /// Whether its density is the same everywhere.
    bool homogeneous() const;
    /// Whether what it does to a ray is an estimate.
    bool drawn() const { return scatters() || !homogeneous(); }
};

/// The medium after a transformation of what it is in: its densities move, its coefficients do not.
Media transformed(Media, const Transform&);

/// The product of the densities at a point. Filter and transmit do not count, nor do limits.
Vec3 density(const Media&, const Vec3& point, const PatternScene&);
/// No channel of the product is greater than this anywhere, if no density is below 0.
Vec3 max_density(const Media&);

/// Media that fill the same place. Their coefficients add up.
using MediaView = std::span<const Media* const>;

/// What media do to light at a point, per unit of length.
struct MediumPoint {
    Vec3 extinction = Vec3(0);
    Vec3 emission = Vec3(0);    ///< radiance, but for that of luminaires
    Vec3 luminaires = Vec3(0);  ///< radiance that luminaires emit
    Vec3 scattering = Vec3(0);  ///< without phase functions
};
MediumPoint coefficients(MediaView, const Vec3& point, const PatternScene&);

/// Radiance that media scatter to the viewer at a point, per unit of length, by light of colour 1
/// from where that cosine is (see phase()).
Vec3 scattered(MediaView, const Vec3& point, const PatternScene&, double cosine);

}  // namespace candelabra
