// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray 3.7's integrator: one camera ray, recursion over all of its reflections and refractions,
// and direct light at their hits. It follows POV-Ray's rules for levels, weights and nested
// interiors. Radiance in a reflection may be raised to a power: a sample is then not a product of
// factors along a path, so the recursion remains.
#pragma once

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
    Vec3 radiance(const Ray& ray, const Key& key);
    /// Radiance that a white element shows. Without Tracing::from_anywhere it lies in the solids
    /// that contain the camera.
    Vec3 element_radiance(const WhiteElement&, const Key&);

    LightLedger& ledger() { return ledger_; }
    const LightLedger& ledger() const { return ledger_; }

    /// Builds the photons for a sample.
    void prepare(std::uint32_t sample) const { photons_.prepare(sample); }

    /// Fraction of the last sample that shows clear background, from 0 to 1.
    double clear() const { return ends_.clear(); }

    /// Whether the last sample had more rays than are followed.
    bool cut() const { return rays_ > max_rays_; }

private:
    Vec3 follow(const PathState&);
    Vec3 surface(const PathState&, const Hit&);
    Vec3 layered(const PathState&, const Vertex&, const Layers&);
    Vec3 lit(const PathState&, const Vertex&, const Shading&, double emission);
    Vec3 gathered(const PathState&, const Vertex&, const Shading&);
    Vec3 gathered_from(const PathState&, const Vertex&, const Shading&, bool behind);
    Vec3 reflected(const PathState&, const Vertex&, const Shading&, const Vec3& amount,
                   double weight);
    Vec3 reflected_to_a_power(const PathState&, const Vertex&, const Shading&, const Vec3& amount,
                              double weight);
    Vec3 scattered(const PathState&, const Vertex&, const Shading&, double weight);
    Vec3 transmitted(const PathState&, const Vertex&, const Shading&, const Interface&,
                     const Vec3& share);
    Vec3 split(const PathState&, const Vertex&, const Shading&, const Interface&,
               const Vec3& share);

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
