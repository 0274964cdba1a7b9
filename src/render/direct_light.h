// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a point: POV-Ray's light sources one by one, or some of them when they are many,
// and luminaires, as the light sampler chooses.
#pragma once

#include "base/random.h"
#include "render/shade.h"
#include "render/statistics.h"

/// Radiance towards the viewer by light that comes straight from lights and luminaires; an unbiased
/// estimate.
class DirectLight {
public:
    DirectLight(const World& world, int shadow_rays) : world_(world), shadow_rays_(shadow_rays) {}

    Vec3 operator()(const Shading&, const Key&, RayCounts&);

private:
    /// A point of a luminaire on a line, and the density of its direction by that luminaire.
    struct Met {
        LightMeeting meeting;
        LightIndex light;
    };
    using Octree = BuiltCutOctree;

    Vec3 from_sky(const Shading&, const Key&, RayCounts&) const;
    Vec3 from_sources(const Shading&, const Key&, RayCounts&);
    Vec3 from_drawn_sources(const SourceSet&, const Shading&, const Key&, RayCounts&);
    Vec3 from_luminaires(const Shading&, const Key&, RayCounts&);
    Vec3 from_source(std::uint32_t light, double weight, const Shading&, const Key&, RayCounts&);
    void credit_luminaire(RayCounts&, LightIndex, const Vec3& seen, std::uint64_t rays) const;
    template <class Sampler>
    Vec3 from_picks(const Sampler&, const Shading&, const Key&, RayCounts&);
    template <class Density>
    Vec3 from_luminaire(const Shading&, const LightPick&, const Key&, RayCounts&,
                        const Density&) const;
    Vec3 from_cuts(const Octree&, const Shading&, const Key&, RayCounts&);
    Vec3 from_cell(const Octree&, const Octree::Weights&, const Shading&, const Key&, RayCounts&);
    std::optional<LightSight> sight(const Ray&, double tolerance) const;
    std::optional<LightSight> sight_past_clear(const Ray&, double tolerance) const;
    template <class Weight>
    Vec3 seen_towards(const Shading&, const Vec3& direction, RayCounts&, const Weight&);
    Vec3 from_pair(const BuiltLightBvh&, const Shading&, const Key&, RayCounts&);
    Vec3 from_surface(const BuiltLightBvh&, const Shading&, const Key&, RayCounts&);
    void meet_along(const LightTree&, const Shading&, const Vec3& direction);
    template <class Weight>
    Vec3 seen_along(const Shading&, const Vec3& direction, RayCounts&, const Weight&) const;
    Vec3 radiance(const Luminaire&, const Vec3& position) const;

    const World& world_;
    int shadow_rays_;
    // Kept from hit to hit for their memory.
    LightPicks picks_;
    LightMeetings meetings_;
    std::vector<Met> met_;  ///< along the line that is asked, nearest first
};
