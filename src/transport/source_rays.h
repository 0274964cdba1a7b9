// SPDX-License-Identifier: GPL-3.0-or-later
// Rays that leave light sources, with the light that each of them stands for: the beginnings of
// photons and of paths of light.
#pragma once

#include "base/function_ref.h"
#include "base/random.h"
#include "base/ray.h"
#include "base/weighted_index.h"
#include "light/light.h"
#include "light/spreading.h"
#include "transport/lit_region.h"
#include "transport/start_guide.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace candelabra {

/// Samples a unit direction in a cone, uniformly per steradian.
Vec3 direction_in_cone(const LightCone&, const Vec2& u);

/// Which light of an area light's grid sends light out, as drawn_grid_point() takes it.
Vec2 place_in_grid(const Key&);

/// A ray that leaves a source, and its extent: a solid angle in steradians, or an area if all light
/// of the source is parallel.
struct SourceRay {
    const PointLight* source;
    Vec3 place;  ///< of the source: the light of its grid that emits the ray
    Ray ray;
    double extent;

    /// Area, perpendicular to the ray, for which it stands after a way of that length. Light of a
    /// source does not fade unless the source says so: so the power in a fixed solid angle grows
    /// with the square of the length.
    double area_after(double way) const {
        return source->along_axis() ? extent : extent * way * way;
    }
    /// Colour of light times area after that way.
    Rgb power_after(double way) const {
        return incidence(*source, place, ray.at(way)).colour * area_after(way);
    }
};

struct TargetBall {
    Vec3 centre;
    double radius;
};

/// Samples a ray from a place of the source into a ball; nothing if the sampled ray misses it. The
/// mean of many is all light that the source sends to the ball. Parallel rays start in the plane
/// through the place.
std::optional<SourceRay> ray_into(const TargetBall&, const PointLight&, const Vec3& place,
                                  const Vec2& u);

/// Samples a ray from the location of the source in any direction in which it may send light, and
/// often into the region. Parallel rays start before all finite things.
SourceRay ray_anywhere(const LitRegion&, const PointLight&, const Vec2& u);

/// Chooses among all sources of a scene, each by about the light that it sends into a region, or by
/// what trials have found.
class SourceRays {
public:
    /// The sources must outlive this.
    SourceRays(std::span<const PointLight>, const LitRegion&);

    /// About the light that all of them send into the region: colour of light times area, as
    /// luminance. 0: none sends any.
    double power() const { return power_; }

    struct Drawn {
        std::uint32_t number;  ///< of the source
        SourceRay ray;         ///< its extent is divided by the probability of the source
    };
    /// `choice` is in [0, 1), and chooses the source. Precondition: power() is above 0.
    Drawn draw(double choice, const Vec2& u) const;

    /// Finds which starts are worth most, by trials if the sources are few. `worth` returns what a
    /// path is worth that starts with a ray of a source.
    void learn(FunctionRef<double(const Drawn&, const Key&)> worth);

private:
    std::span<const PointLight> sources_;
    LitRegion region_;
    std::vector<double> powers_;
    double power_ = 0;
    WeightedIndex places_;
    std::vector<StartGuide> guides_;  ///< of each source; empty: nothing was learned
};

}  // namespace candelabra
