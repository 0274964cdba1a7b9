// SPDX-License-Identifier: GPL-3.0-or-later
// Participating media, which absorb, emit and scatter light between surfaces: in the interior of a
// solid, or everywhere outside solids. As in POV-Ray 3.7, coefficients are per unit of length of
// the scene, even if the solid is scaled. Isotropic scattering of colour 1 along one unit of length
// sends the light's whole colour to the viewer. That is four times the light of a phase function
// whose integral is 1, as light of colour 1 has an irradiance of pi.
#pragma once

#include "base/rgb.h"
#include "surface/pigment.h"
#include "vocabulary/item_info.h"

#include <span>
#include <string>
#include <vector>

namespace candelabra {

/// Phase functions by POV-Ray's numbers. Other numbers act as isotropic.
enum class PhaseKind : int { isotropic = 1, mie_haze, mie_murky, rayleigh, henyey_greenstein };

/// Light by how often media without `multiple` have scattered it. These scatter light once on its
/// way, and other media as often as it comes.
enum class LightInAir {
    any,              ///< no such medium has scattered it yet
    repeatedly_only,  ///< one has, so that only media with `multiple` scatter it
    once_only         ///< is to be scattered by one: only media without `multiple` count
};

/// How a medium scatters light.
struct Scattering {
    int type = 1;             ///< see PhaseKind
    Rgb colour = Rgb(0);      ///< scattering coefficient, per unit of length; any sign
    double extinction = 1;    ///< fraction of the scattered light that the ray loses; any sign
    double eccentricity = 0;  ///< of type 5: above 0, light scatters forward
    bool multiple = false;    ///< whether paths scatter light repeatedly
    /// Whether it scatters exactly the light that it takes at an extinction of 1, as must be where
    /// light is scattered repeatedly: the integral of its phase function is 1. If not, it has
    /// POV-Ray's unit. Set when a world is compiled.
    bool physical = false;

    static const ItemInfo vocabulary;
};

/// Returns the phase function times 4 pi: 1 for isotropic scattering. `cosine` is that of the angle
/// between the directions of the view and to the light: 1 looks into the light. Types 2, 3 and 4
/// have POV-Ray's constants, whose means over the sphere are 1.153, 1.247 and 1.066.
double phase(const Scattering&, double cosine);
/// The mean of phase() over the sphere.
double mean_phase(const Scattering&);
/// Factor on phase(): 1 in POV-Ray's unit.
double unit_of_light(const Scattering&);

/// One medium. The product of all its densities, per channel, multiplies all three coefficients.
struct Media {
    Rgb absorption = Rgb(0);  ///< per unit of length; any sign
    Rgb emission = Rgb(0);    ///< radiance per unit of length; any sign
    Scattering scattering;
    std::vector<Pigment> densities;  ///< in the space around the medium; none: 1 everywhere
    // POV-Ray's sampling parameters. They give the effort, and do not change the expected image.
    int method = 3;
    int intervals = 1;
    int samples = 10;
    int max_samples = 0;  ///< a value below `samples` counts as `samples`
    int aa_level = 3;
    double aa_threshold = 0.1;
    double confidence = 0.9;
    double variance = 1.0 / 128;
    double ratio = 0.9;
    double jitter = 0;
    bool collect = true;
    /// Whether its emission counts as a luminaire's; set when a world is compiled.
    bool luminaire = false;

    static const ItemInfo vocabulary;

    bool scatters() const { return scattering.colour != Rgb(0); }
    /// Whether it scatters that light.
    bool scatters(LightInAir light) const {
        return scatters() && (scattering.multiple ? light != LightInAir::once_only
                                                  : light != LightInAir::repeatedly_only);
    }
    /// Extinction coefficient at a density of 1, per unit of length.
    Rgb extinction() const { return absorption + scattering.extinction * scattering.colour; }
    /// Whether its density is constant.
    bool homogeneous() const;
    /// Whether its effect on a ray is estimated by random samples.
    bool drawn() const { return scatters() || !homogeneous(); }
};

/// Returns the medium after a transformation of its container: densities are transformed,
/// coefficients are not.
Media transformed(Media, const Transform&);

/// Product of the densities at a point. Filter, transmit and limits are ignored.
Rgb density(const Media&, const Vec3& point, const PatternScene&);
/// Upper bound of the product of the densities, per channel, provided that none is below 0.
Rgb max_density(const Media&);

/// Media that fill the same space. Their coefficients add up.
using MediaView = std::span<const Media* const>;

/// Coefficients of media at a point, per unit of length.
struct MediumPoint {
    Rgb extinction = Rgb(0);
    Rgb emission = Rgb(0);    ///< radiance, without that of luminaires
    Rgb luminaires = Rgb(0);  ///< radiance emitted by luminaires
    Rgb scattering = Rgb(0);  ///< without phase functions
};
/// `light` is what may be scattered.
MediumPoint coefficients(MediaView, const Vec3& point, const PatternScene&,
                         LightInAir light = LightInAir::any);

/// Radiance per unit of length that media at a point scatter towards the viewer, for light of
/// colour 1 at this cosine (see phase()).
Rgb scattered(MediaView, const Vec3& point, const PatternScene&, double cosine);

}  // namespace candelabra
