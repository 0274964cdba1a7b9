// SPDX-License-Identifier: GPL-3.0-or-later
// A layer of a surface, or media, at a vertex whose light is wanted.
#pragma once

#include "base/random.h"
#include "base/rgb.h"
#include "scattering/scatterer.h"
#include "transport/light_kinds.h"
#include "transport/vertex.h"

namespace candelabra {

/// The layer or the media at a vertex that respond to light, and the kinds of light that count.
struct LitLayer {
    const Vertex& vertex;
    Scatterer scatterer;
    LightKinds light;           ///< the kinds that count
    Rgb throughput = Rgb(1);    ///< of the layer's radiance, in the sample
    bool highlights = true;     ///< phong and specular highlights count
    /// One random light of an area light's grid casts a shadow, in the place of all of them.
    bool samples_grids = false;
    /// Settings of the radiosity that gathers the luminaires' light; null: nothing gathers it.
    const Radiosity* radiosity = nullptr;

    /// The random number of the finish's `crand`.
    double grain(const Key& key) const {
        const bool grainy = !scatterer.in_air() && scatterer.bsdf().shading().finish->crand > 0;
        return grainy ? uniform(key, Purpose::grain) : 0;
    }
    /// The terms of the BSDF by which it responds. Brilliance does not apply to light that
    /// radiosity gathers.
    BsdfTerms terms() const { return {highlights, !radiosity, FacetLobes::wide}; }
    /// Radiance towards the viewer due to light of colour 1 from a unit direction.
    Rgb response(const Vec3& direction, const Key& key) const {
        return scatterer.evaluate(direction, terms(), grain(key));
    }
    /// Radiance from one direction, as radiosity counts it.
    Rgb counted(const Rgb& radiance) const {
        return radiosity ? gathered_light(*radiosity, radiance) : radiance;
    }
    /// Whether photons light the layer instead of direct light through targets. If the scene asks
    /// for no photons in media, media are dark behind a target, as in POV-Ray.
    bool collects() const {
        return scatterer.in_air() ? scatterer.phase().collects()
                                  : vertex.material->photons.collects;
    }
};

}  // namespace candelabra
