// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray 3.7's way of following light: one ray of the camera, all reflections and refractions of
// it by recursion, and direct light where they end. With POV-Ray's rules for levels, weights and
// nested interiors. What a reflection shows may be raised to a power, so that a sample is no plain
// product of what its path has met, and the recursion stays.
#pragma once

#include "transport/direct_light.h"
#include "transport/participating_media.h"
#include "transport/path_steps.h"
#include "transport/tracing.h"

namespace candelabra {

class PovRayIntegrator {
public:
    PovRayIntegrator(const World& world, const Tracing&);

    /// Radiance that comes along a camera ray; an unbiased estimate, a pure function of ray and
    /// key.
    Vec3 radiance(const Ray& ray, const Key& key);

    LightLedger& ledger() { return ledger_; }
    const LightLedger& ledger() const { return ledger_; }
    const HitNoise& noise() const { return direct_light_.noise(); }

    /// Makes the photons that samples from `first` to before `last` need.
    void prepare(std::uint32_t first, std::uint32_t last) const {
        direct_light_.photons().prepare(first, last);
    }

    /// How much of the last sample is what is behind everything and clear: 0 to 1.
    double clear() const { return ends_.clear(); }

private:
    Vec3 follow(const PathState&);
    Vec3 surface(const PathState&, const Hit&);
    Vec3 layered(const PathState&, const Vertex&, std::span<const Layer>);
    Vec3 lit(const PathState&, const Vertex&, const Shading&, bool emission);
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
    DirectLight direct_light_;
    ParticipatingMedia media_;
    PathEnds ends_;
    LightLedger ledger_;
};

}  // namespace candelabra
