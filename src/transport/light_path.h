// SPDX-License-Identifier: GPL-3.0-or-later
// Light paths that start at luminaires. They leave a reflected luminaire at each diffuse surface
// that reflects their light, and continue from there.
#pragma once

#include "transport/lamp_rays.h"
#include "transport/layer_stack.h"
#include "world/shot.h"

#include <vector>

namespace candelabra {

/// A point of a diffuse surface that stands for all light that arrives on the surface. The sum over
/// many sampled points is an unbiased estimate of the light that all diffuse surfaces reflect.
struct ReflectedLuminaire {
    Vec3 position;
    Vec3 normal;              ///< unit geometric normal, on the side that reflects
    Vec3 power;               ///< radiance, equal in all directions of that side, times area
    double tolerance = 0;     ///< of the hit
    int reflections = 1;      ///< diffuse ones on the light's way, including this one
    Lamp lamp = Lamp::sky();  ///< that sent the light
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

    /// Whether there are luminaires from which light can be followed.
    bool any() const { return lamp_rays_.any(); }

    /// Follows one path, and adds its reflected luminaires. `share` is a factor on their power.
    void follow(const Key&, double share, std::vector<ReflectedLuminaire>&) const;

private:
    struct Lit;

    void go_on(Lit, std::vector<ReflectedLuminaire>&) const;
    Vec3 reflected(const PathState&, const Vertex&) const;
    Vertex other_side(const PathState&, const Vertex&) const;

    const Shot& shot_;
    const World& world_;
    ShadingRules rules_;
    LampRays lamp_rays_;
    int max_reflections_;
};

}  // namespace candelabra
