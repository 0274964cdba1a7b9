// SPDX-License-Identifier: GPL-3.0-or-later
// Light paths that start at luminaires, light sources and a sky that is a luminaire. They leave a
// reflected luminaire at each diffuse surface that reflects their light, and where media scatter
// it, and continue from there.
#pragma once

#include "base/rgb.h"
#include "transport/lamp_rays.h"
#include "transport/layer_stack.h"
#include "transport/light_left.h"
#include "transport/sky_rays.h"
#include "transport/source_rays.h"
#include "world/shot.h"

#include <vector>

namespace candelabra {

/// A point of a diffuse surface that stands for all light that arrives on the surface, or a point
/// of a medium. The sum over many sampled points is an unbiased estimate of the light that all
/// diffuse surfaces reflect, and all media scatter.
struct ReflectedLuminaire {
    Vec3 position;
    /// Unit geometric normal, on the side that reflects; in a medium, where the light went.
    Vec3 normal;
    /// Radiance, equal in all directions of that side, times area. In a medium, radiance per unit
    /// of length times volume, for a phase() of 1.
    Rgb power;
    double tolerance = 0;     ///< of the hit
    int reflections = 1;      ///< diffuse ones on the light's way, including this one
    Lamp lamp = Lamp::sky();  ///< that sent the light
    const Scattering* scattering = nullptr;  ///< of the medium; null: a surface
    bool scattered = false;  ///< a medium without `multiple` has scattered the light

    bool in_air() const { return scattering != nullptr; }
};

/// Whether reflected luminaires can stand for the diffuse reflection of a layer at a vertex, and
/// for the light that passes it from behind: its radiance is the same in all directions of a side.
bool is_even_on_each_side(const World&, const Vertex&, const Shading&);
/// Whether they can light it: it is even, and has no light from behind.
bool is_lambertian(const World&, const Vertex&, const Shading&);

class LightPaths {
public:
    /// `max_reflections`: the most diffuse reflections after which light still counts.
    LightPaths(const Shot&, int max_reflections);

    /// Whether there is light that can be followed.
    bool any() const { return power_ > 0; }

    /// Follows one path, and adds its reflected luminaires. `share` is a factor on their power.
    /// Precondition: any().
    void follow(const Key&, double share, std::vector<ReflectedLuminaire>&) const;

    /// The same paths with another number of reflections.
    LightPaths with_reflections(int most) const {
        LightPaths other = *this;
        other.max_reflections_ = most;
        return other;
    }

    /// Whether they leave reflected luminaires in media, too.
    bool scatter() const { return in_air_; }
    /// Places that the camera sees, to which the starts of paths lead most light.
    const std::vector<SeenPlace>& seen() const { return seen_; }
    /// Where paths from light sources and the sky mostly arrive.
    const LitRegion& region() const { return region_; }

private:
    LightPaths(const Shot&, int max_reflections, std::vector<SeenPlace>);

    struct Lit;
    using Found = std::vector<ReflectedLuminaire>;

    void learn();
    void from_luminaire(const Key&, double choice, double share, Found&) const;
    void from_source(const SourceRays::Drawn&, const Key&, double share, Found&) const;
    void from_sky(const SkyRays::Drawn&, const Key&, double share, Found&) const;
    template <class AtPlace, class AtSurface>
    void walk(PathState, const AtPlace&, const AtSurface&) const;
    PathState start(const Key&, const Ray&) const;
    void go_on(Lit, Found&) const;
    void leave(const Lit&, Found&) const;
    bool send_on(Lit&) const;
    bool arrive(Lit&) const;
    std::optional<Lit> in_air(const PathState&, double distance, bool scattered) const;
    bool is_brought(const WayOfLight&, const Vertex&) const;
    bool reflect(Lit&) const;
    Rgb arriving_of_source(std::uint32_t number, const Vertex&, const PathState&) const;
    Rgb reflected(const PathState&, const Vertex&) const;
    Rgb reflected_of_source(std::uint32_t number, const PathState&, const Vertex&) const;
    bool reflect_source(std::uint32_t number, double area, Lit&) const;
    Vertex other_side(const PathState&, const Vertex&) const;

    const Shot& shot_;
    const World& world_;
    ShadingRules rules_;
    std::vector<SeenPlace> seen_;
    LitRegion region_;
    LampRays lamp_rays_;
    SourceRays source_rays_;
    SkyRays sky_rays_;
    double power_;  ///< about the light of all of them
    int max_reflections_;
    bool in_air_;  ///< see stands_for_scattering()
};

}  // namespace candelabra
