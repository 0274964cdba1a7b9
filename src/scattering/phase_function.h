// SPDX-License-Identifier: GPL-3.0-or-later
// How the media at one point scatter light to the viewer: the sum of what each of them does, and
// directions drawn as they do so.
#pragma once

#include "base/short_list.h"
#include "lighting/light_query.h"
#include "medium/media.h"

namespace candelabra {

/// Whether light that photons bring shows in the media: they scatter, and none that does says no.
bool collects_photons(MediaView);

class PhaseFunction {
public:
    /// `view` is the unit direction of the ray that sees the point; `weight` is by what the light
    /// that is scattered there is multiplied.
    PhaseFunction(MediaView, const Vec3& position, const Vec3& view, const PatternScene&,
                  const Vec3& weight = Vec3(1));

    bool answers_light() const { return total_ > 0; }
    /// Radiance towards the viewer, per unit of length times the weight, by light of colour 1 from
    /// a unit direction.
    Vec3 evaluate(const Vec3& to_light) const;
    /// A unit direction, drawn as light that comes from everywhere is scattered; u is in [0, 1)^2.
    /// Precondition: it answers light.
    Vec3 sample(Vec2 u) const;
    /// Probability per steradian of that direction.
    double pdf(const Vec3& direction) const;
    /// A point between surfaces has no horizon.
    Receiver receiver() const { return {position_, Vec3(0), Horizon::none}; }
    /// Whether a medium scatters light again and again.
    bool multiple() const { return multiple_; }
    bool collects() const { return collects_; }  ///< see collects_photons()

private:
    struct Part {
        Vec3 coefficient;
        const Scattering* scattering;
        double share;  ///< of the directions that are drawn
    };

    Vec3 position_, view_;
    ShortList<Part, 4> parts_;
    double total_ = 0;
    bool multiple_ = false, collects_ = false;
};

}  // namespace candelabra
