// SPDX-License-Identifier: GPL-3.0-or-later
// A scattering vertex of a path: a layer of a surface, or the media between surfaces.
#pragma once

#include "base/rgb.h"
#include "scattering/bsdf.h"
#include "scattering/phase_function.h"

namespace candelabra {

/// Refers to a BSDF or a phase function, which outlives it. Throughout, light of colour 1 has a
/// perpendicular irradiance of pi; values for media are radiance per unit of length.
class Scatterer {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): it stands for the object it refers to
    Scatterer(const Bsdf& bsdf) : bsdf_(&bsdf) {}
    // NOLINTNEXTLINE(google-explicit-constructor)
    Scatterer(const PhaseFunction& phase) : phase_(&phase) {}

    bool in_air() const { return phase_ != nullptr; }
    /// Precondition: not in the air.
    const Bsdf& bsdf() const { return *bsdf_; }
    /// Precondition: in the air.
    const PhaseFunction& phase() const { return *phase_; }

    /// Whether light from any direction is scattered towards the viewer.
    bool answers_light() const { return bsdf_ ? bsdf_->answers_light() : phase_->answers_light(); }
    /// Radiance towards the viewer due to light of colour 1 from a unit direction. `grain` is the
    /// random number for `crand`.
    Rgb evaluate(const Vec3& to_light, const BsdfTerms& terms, double grain) const {
        return bsdf_ ? bsdf_->evaluate(to_light, terms, grain) : phase_->evaluate(to_light);
    }
    /// Returns a unit direction drawn roughly in proportion to the scattering of uniform light; u
    /// is in [0, 1)^2.
    std::optional<Vec3> sample(Vec2 u) const {
        return bsdf_ ? bsdf_->sample(u) : phase_->sample(u);
    }
    /// Density of sample() per steradian.
    double pdf(const Vec3& direction) const {
        return bsdf_ ? bsdf_->pdf(direction) : phase_->pdf(direction);
    }
    /// Fraction of the directions that are drawn from highlights.
    double specular_probability() const { return bsdf_ ? bsdf_->specular_probability() : 0; }
    /// The lobes as the light samplers represent them.
    BsdfLobes lobes() const { return bsdf_ ? bsdf_->lobes() : BsdfLobes{}; }

private:
    const Bsdf* bsdf_ = nullptr;
    const PhaseFunction* phase_ = nullptr;
};

}  // namespace candelabra
