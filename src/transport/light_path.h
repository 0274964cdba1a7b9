// SPDX-License-Identifier: GPL-3.0-or-later
// Paths of light that leave luminaires: where a diffuse surface reflects their light they leave a
// reflected luminaire, and go on from there.
#pragma once

#include "lighting/dim_set.h"
#include "transport/layer_stack.h"

#include <vector>

namespace candelabra {

/// A point of a diffuse surface that stands for all light which comes to it. Of many points drawn
/// so the sum is an unbiased estimate of the light that all diffuse surfaces reflect.
struct ReflectedLuminaire {
    Vec3 position;
    Vec3 normal;  ///< unit, of the surface as it is, on the side that shines
    Vec3 power;   ///< radiance, which is the same in all directions of that side, times area
    double tolerance = 0;         ///< of the hit
    int reflections = 1;          ///< diffuse ones on the light's way, the last one included
    std::uint32_t statement = 0;  ///< in Provenance::light_statements, that made its lamp
};

/// Whether reflected luminaires can stand for the diffuse reflection of a layer at a vertex: it is
/// the same in all directions of one side.
bool is_lambertian(const World&, const Vertex&, const Shading&);
/// The terms of such a layer's BSDF.
inline constexpr BsdfTerms diffuse_terms{.highlights = false, .facets = FacetLobes::none};

class LightPaths {
public:
    /// Light counts after so many diffuse reflections at most.
    LightPaths(const World&, int max_reflections);

    /// Whether there are lamps to follow light from.
    bool any() const { return places_.total() > 0; }

    /// Follows one path. `share`: by what its power is multiplied.
    void follow(const Key&, double share, std::vector<ReflectedLuminaire>&) const;

private:
    struct Lit;

    void go_on(Lit, std::vector<ReflectedLuminaire>&) const;
    Vec3 reflected(const PathState&, const Vertex&) const;

    const World& world_;
    ShadingRules rules_;
    LightPlaces places_;  ///< of the luminaires, by their intensity
    int max_reflections_;
};

}  // namespace candelabra
