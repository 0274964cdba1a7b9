// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray 3.7's integrator: one camera ray, recursion over all of its reflections and refractions,
// and direct light at their hits. It follows POV-Ray's rules for levels, weights and nested
// interiors. Radiance in a reflection may be raised to a power: a sample is then not a product of
// factors along a path, so the recursion remains.
#pragma once

#include "base/rgb.h"
#include "transport/direct_light.h"
#include "transport/participating_media.h"
#include "transport/path_steps.h"
#include "transport/photons.h"
#include "transport/tracing.h"
#include "transport/white_element.h"

namespace candelabra {

class PovRayIntegrator {
public:
    PovRayIntegrator(const Shot&, const Tracing&);

    /// Radiance along a camera ray; an unbiased estimate, and a pure function of ray and key.
    Rgb radiance(const Ray& ray, const Key& key);
    /// Radiance that a white element shows. Without Tracing::from_anywhere it lies in the solids
    /// that contain the camera.
    Rgb element_radiance(const WhiteElement&, const Key&);

    LightLedger& ledger() { return ledger_; }
    const LightLedger& ledger() const { return ledger_; }

    /// Builds the photons for a sample.
    void prepare(std::uint32_t sample) const { photons_.prepare(sample); }

    /// Fraction of the last sample that shows clear background, from 0 to 1.
    double clear() const { return ends_.clear(); }

    /// Whether the last sample had more rays than are followed.
    bool cut() const { return rays_ > max_rays_; }

private:
    Rgb follow(const PathState&);
    Rgb surface(const PathState&, const Hit&);
    Rgb layered(const PathState&, const Vertex&, const Layers&);
    Rgb lit(const PathState&, const Vertex&, const Shading&, double emission);
    Rgb gathered(const PathState&, const Vertex&, const Shading&);
    Rgb gathered_from(const PathState&, const Vertex&, const Shading&, bool behind);
    Rgb reflected(const PathState&, const Vertex&, const Shading&, const Rgb& amount,
                  double weight);
    Rgb reflected_to_a_power(const PathState&, const Vertex&, const Shading&, const Rgb& amount,
                             double weight);
    Rgb scattered(const PathState&, const Vertex&, const Shading&, double weight);
    Rgb transmitted(const PathState&, const Vertex&, const Shading&, const Interface&,
                    const Rgb& share);
    Rgb split(const PathState&, const Vertex&, const Shading&, const Interface&, const Rgb& share);

    const World& world_;
    const Radiosity& radiosity_;
    ShadingRules rules_;
    ServedGeneration<Photons> photons_;
    DirectLight direct_light_;
    ParticipatingMedia media_;
    PathEnds ends_;
    LightLedger ledger_;
    /// Reflections and refractions of one camera ray may double at each level: the product of their
    /// weights need not fall where surfaces keep all light.
    std::uint64_t rays_ = 0, max_rays_;
};

}  // namespace candelabra
