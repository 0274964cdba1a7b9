// SPDX-License-Identifier: GPL-3.0-or-later
// Direct light at a point: POV-Ray's light sources one by one, or some of them when they are many,
// and luminaires, as the light sampler chooses.
#pragma once

#include "base/random.h"
#include "render/scattering.h"
#include "render/shade.h"
#include "render/statistics.h"

/// The point as luminaires see it.
ShadingPoint point_of(const Shading&);

/// How many shadow rays hits get.
struct ShadowRays {
    // NOLINTNEXTLINE(google-explicit-constructor): one number for all is the plain case
    ShadowRays(int usual_number = 1, double noise = 0) : usual(usual_number), usual_noise(noise) {}

    int usual;
    /// Standard deviation of one shadow ray, times what the hit counts for the pixel, at which a
    /// hit gets the usual number: others get more or fewer in proportion, which is what makes the
    /// least noise of a given number of rays. 0: all get the usual number.
    double usual_noise;
};

/// What one shadow ray is expected to make of noise (see ShadowRays), over many hits.
struct HitNoise {
    double sum = 0, squares = 0;
    int hits = 0;

    HitNoise& operator+=(const HitNoise& other) {
        sum += other.sum;
        squares += other.squares;
        hits += other.hits;
        return *this;
    }
};

/// Radiance towards the viewer by light that comes straight from lights and luminaires; an unbiased
/// estimate.
class DirectLight {
public:
    DirectLight(const World& world, const ShadowRays& rays) : world_(world), shadow_rays_(rays) {}

    Vec3 operator()(const Shading&, const Key&, RayCounts&);

    /// Of all hits so far at which it was known.
    const HitNoise& noise() const { return noise_; }

private:
    /// A point of a luminaire on a line, and the density of its direction by that luminaire.
    struct Met {
        LightMeeting meeting;
        LightIndex light;
    };
    using Octree = BuiltCutOctree;

    Vec3 from_sky(const Scattering&, const Shading&, const Key&, RayCounts&) const;
    Vec3 from_sources(const Scattering&, const Shading&, const Key&, RayCounts&);
    Vec3 from_drawn_sources(const SourceSet&, const Scattering&, const Shading&, const Key&,
                            RayCounts&);
    Vec3 from_luminaires(const Scattering&, const Shading&, const Key&, const Vec3& before,
                         RayCounts&);
    Vec3 from_source(std::uint32_t light, double weight, const Shading&, const Key&, RayCounts&);
    void credit_luminaire(RayCounts&, LightIndex, const Vec3& seen, std::uint64_t rays) const;
    template <class Sampler>
    Vec3 from_picks(const Sampler&, const Shading&, const Key&, RayCounts&);
    /// Density: of a drawn point, by its direction and what the luminaire says (per steradian).
    template <class Density>
    Vec3 from_luminaire(const Shading&, const LightPick&, const Key&, RayCounts&, const Density&);
    /// `before`: the radiance that arrives of point lights.
    Vec3 from_cuts(const Octree&, const Scattering&, const Shading&, const Key&, const Vec3& before,
                   RayCounts&);
    Vec3 from_cell(const Octree&, const Octree::Weights&, const Scattering&, const Shading&,
                   const Key&, RayCounts&);
    std::optional<LightSight> sight(const Ray&, double tolerance) const;
    std::optional<LightSight> sight_past_clear(const Ray&, double tolerance) const;
    /// Of a hit.
    struct Distance {
        double distance, tolerance;
    };
    template <class Visit>
    void for_densities(LightIndex, const Shading&, const Vec3& direction, const Distance&,
                       const Visit&);
    /// Weight: by the luminaire and the density with which it says the point is drawn.
    template <class Weight>
    Vec3 seen_towards(const Shading&, const Vec3& direction, RayCounts&, const Weight&);
    Vec3 from_pair(const BuiltLightBvh&, const Scattering&, const Shading&, const Key&, RayCounts&);
    Vec3 from_surface(const BuiltLightBvh&, const Scattering&, const Shading&, const Key&,
                      RayCounts&);
    void meet_along(const LightTree&, const Shading&, const Vec3& direction);
    template <class Weight>
    Vec3 seen_along(const Shading&, const Vec3& direction, RayCounts&, const Weight&) const;
    Vec3 radiance(const Luminaire&, const Vec3& position) const;

    double chance_of_asking(const Octree::Weights&, const Vec3& straight, const Vec3& before,
                            const RayCounts&) const;
    int rays_at(const Octree::Weights&, const Vec3& straight, const RayCounts&);

    const World& world_;
    ShadowRays shadow_rays_;
    int rays_here_ = 1;      ///< that the hit gets
    double asked_here_ = 1;  ///< as many are expected
    HitNoise noise_;
    // Kept from hit to hit for their memory.
    LightPicks picks_;
    LightMeetings meetings_;
    std::vector<Met> met_;  ///< along the line that is asked, nearest first
};
