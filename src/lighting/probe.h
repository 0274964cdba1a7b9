// SPDX-License-Identifier: GPL-3.0-or-later
// The rays by which a light strategy probes the scene. They are the renderer's: lighting/ knows no
// World.
#pragma once

#include "base/function_ref.h"
#include "base/ray.h"
#include "lighting/pick.h"

#include <optional>

namespace candelabra {

/// First hit of a ray that probes the scene.
struct ProbeHit {
    double distance = 0;
    Vec3 normal = Vec3(0);  ///< unit, outward
    double tolerance = 0;   ///< for rays that start there
    std::optional<LightIndex> light;
    double luminance = 0;
    double passes = 0;  ///< fraction of light from behind that the surface transmits
};
/// Returns the first hit of a ray beyond the tolerance; nothing if there is none.
using LightProbe = FunctionRef<std::optional<ProbeHit>(const Ray&, double tolerance)>;

/// Calls visit(const ProbeHit&, double share) for the ray's hits one after the other, with the
/// fraction of their light that reaches the ray's origin, until visit returns true or no light
/// passes. Returns the fraction of light from behind everything that reaches it: 0 if visit has
/// ended the walk.
template <class Visit>
double look_along(const Ray& ray, double tolerance, const LightProbe& probe, Visit visit) {
    constexpr int max_surfaces = 16;  // what lies behind more is left to chance
    double share = 1;
    for (int i = 0; i < max_surfaces && share > 0; ++i) {
        const auto sight = probe(ray, tolerance);
        if (!sight) return share;
        if (visit(*sight, share)) return 0;
        share *= sight->passes;
        tolerance = sight->distance + sight->tolerance;
    }
    return 0;
}

}  // namespace candelabra
