// SPDX-License-Identifier: GPL-3.0-or-later
// Combined phase function of the media at one point: evaluates and samples how they scatter light
// towards the viewer.
#pragma once

#include "base/rgb.h"
#include "base/short_list.h"
#include "lighting/light_query.h"
#include "medium/media.h"

namespace candelabra {

/// Whether photons contribute light in the media: some scatter, and none of these disables
/// `collect`.
bool collects_photons(MediaView);

class PhaseFunction {
public:
    /// `view` is the unit direction of the ray that sees the point; `weight` is the factor of the
    /// light scattered there; `light` is what may be scattered.
    PhaseFunction(MediaView, const Vec3& position, const Vec3& view, const PatternScene&,
                  const Rgb& weight = Rgb(1), LightInAir light = LightInAir::any);

    bool answers_light() const { return total_ > 0; }
    /// Radiance towards the viewer per unit of length, times the weight, due to light of colour 1
    /// from a unit direction.
    Rgb evaluate(const Vec3& to_light) const;
    /// Mean of evaluate() over all directions.
    Rgb mean() const;
    /// Fraction of uniform light that is scattered towards the viewer per unit of length, times the
    /// weight. Light from one steradian of radiance 1 is light of colour 1/pi.
    Rgb share() const { return 4.0 * mean(); }
    /// Returns a unit direction drawn in proportion to the scattering of uniform light; u is in
    /// [0, 1)^2. Precondition: answers_light().
    Vec3 sample(Vec2 u) const;
    /// Density of sample() per steradian.
    double pdf(const Vec3& direction) const;
    /// The scattering by one of the media.
    struct Part {
        Rgb coefficient;
        const Scattering* scattering;
        double share;  ///< fraction of the drawn directions

        /// evaluate() of the part alone, at a cosine as of phase().
        Rgb evaluate(double cosine) const { return coefficient * phase(*scattering, cosine); }
        /// Draws that cosine in proportion to phase(); u is in [0, 1).
        double draw_cosine(double u) const;
        /// Density of draw_cosine() per steradian.
        double pdf(double cosine) const;
    };
    /// Returns the part that u in [0, 1) draws by its share. Precondition: answers_light().
    const Part& part(double u) const;
    /// The point as a receiver: without a horizon.
    Receiver receiver() const { return {position_, Vec3(0), Horizon::none}; }
    /// Fraction of the drawn directions by media with `multiple`.
    double multiple() const { return multiple_; }
    bool collects() const { return collects_; }  ///< see collects_photons()

private:
    /// The same as part(); the number becomes its place within the part's share, in [0, 1).
    const Part& chosen(double& u) const;

    Vec3 position_, view_;
    ShortList<Part, 4> parts_;
    double total_ = 0, multiple_ = 0;
    bool collects_ = false;
};

}  // namespace candelabra
