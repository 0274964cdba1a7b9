// SPDX-License-Identifier: GPL-3.0-or-later
// The point where a path meets a surface, and the surface's appearance there: the bridge from a hit
// of the world to the BSDFs of its layers. It may also be a point between surfaces.
#pragma once

#include "base/short_list.h"
#include "scattering/scatterer.h"
#include "scattering/shading.h"
#include "surface/texture.h"
#include "world/world.h"

#include <span>

namespace candelabra {

struct Vertex {
    Hit hit;
    Shading shading;  ///< properties that all layers share; no layer's appearance
    const Material* material = nullptr;
    std::span<const PrimitiveIndex> around = {};  ///< solids that contain the ray to the vertex

    const Vec3& position() const { return shading.position; }
    double tolerance() const { return hit.tolerance; }
};

/// The vertex where the ray has met a surface.
Vertex vertex_at(const World&, const Ray&, const Hit&, std::span<const PrimitiveIndex> around = {});

/// The shading of one layer at the vertex.
Shading with_layer(const World&, const Vertex&, const Layer&);

/// The world's settings for the shading of its surfaces.
ShadingRules shading_rules(const World&);

/// BsdfTerms::through_surface for light of sources: only the integrator that follows POV-Ray counts
/// it.
bool passes_surfaces(const World&);

/// The receiver of light at a surface or a scatterer.
Receiver receiver(const Shading&);
Receiver receiver(const Scatterer&);

/// A vertex between surfaces, seen along the ray, inside the solids `around`.
Vertex vertex_in_air(const World&, const Ray&, double distance,
                     std::span<const PrimitiveIndex> around);

/// The layers of one texture, top first; at least one.
using Layers = ShortList<Layer, 4>;

/// One of the textures that are mixed at a vertex.
struct VisibleTexture {
    double weight;  ///< its share
    Layers layers;
};
using VisibleTextures = ShortList<VisibleTexture, 2>;

/// The textures that show at a vertex, at least one, with shares that add up to 1. If the ray comes
/// from inside, these are the textures of the inner side. Those with a smaller share than `least`
/// are left out.
VisibleTextures visible_textures(const World&, const Vertex&, double least = 0);
/// One of them, with its share as the probability; `u` is in [0, 1). Null if the shares' rounding
/// errors leave none.
const VisibleTexture* choose(const VisibleTextures&, double u);

}  // namespace candelabra
