// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that leave luminaires, each of which is chosen by its intensity: the beginnings of paths of
// light.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/weighted_index.h"
#include "luminaire/luminaire.h"
#include "transport/path.h"

#include <optional>

namespace candelabra {

struct LampRay {
    LightIndex light;
    PathState path;  ///< its ray begins on the luminaire; its throughput is 1
    /// Colour of light times area, if the luminaire has radiance 1 along the ray: the mean over
    /// many rays of all luminaires is their power over pi.
    double power_of_one;
};

/// The numbers by which a luminaire sends a ray out.
EmissionDraw emission_draw(const Key&);

class LampRays {
public:
    /// The world must outlive this.
    explicit LampRays(const World&);

    /// Whether there are luminaires with light.
    bool any() const { return places_.total() > 0; }

    /// About the light of all luminaires: colour of light times area, as luminance.
    double power() const { return power_; }

    /// Draws a ray; nothing if no point of the luminaire is drawn. `choice` is in [0, 1), and
    /// chooses the luminaire; `share` is a factor on its power, and `inner` the fraction of a
    /// luminaire's rays on its inner side, as in emit(). Precondition: any().
    std::optional<LampRay> draw(const Key&, double choice, double share,
                                FunctionRef<double(const Luminaire&)> inner) const;
    /// The same, where the key chooses.
    std::optional<LampRay> draw(const Key& key, double share,
                                FunctionRef<double(const Luminaire&)> inner) const {
        return draw(key, uniform(key, Purpose::sender_choice), share, inner);
    }

private:
    const World& world_;
    /// Luminaires, instances and boxes of media in this order, weighted by their intensity.
    WeightedIndex places_;
    double power_ = 0;
};

}  // namespace candelabra
