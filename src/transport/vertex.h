// SPDX-License-Identifier: GPL-3.0-or-later
// The point where a path meets a surface, with what the surface looks like there: the bridge from
// a hit of the world to the BSDFs of its layers. Also a point between surfaces.
#pragma once

#include "scattering/scatterer.h"
#include "scattering/shading.h"
#include "surface/texture.h"
#include "world/world.h"

#include <span>

namespace candelabra {

struct Vertex {
    Hit hit;
    Shading shading;  ///< what all layers have in common; the look of none of them
    const Material* material = nullptr;
    std::span<const PrimitiveIndex> around = {};  ///< solids that the ray which sees it is in

    const Vec3& position() const { return shading.position; }
    double tolerance() const { return hit.tolerance; }
};

/// Where the ray has met a surface.
Vertex vertex_at(const World&, const Ray&, const Hit&, std::span<const PrimitiveIndex> around = {});

/// The look of one layer there.
Shading with_layer(const World&, const Vertex&, const Layer&);

/// Settings of the world that its surfaces are shaded by.
ShadingRules shading_rules(const World&);

/// Where a luminaire's light arrives.
Receiver receiver(const Shading&);
Receiver receiver(const Scatterer&);

/// A point between surfaces, seen along the ray, in the solids that are around it.
Vertex vertex_in_air(const World&, const Ray&, double distance,
                     std::span<const PrimitiveIndex> around);

/// Calls use(weight, layers) for the layers of each texture that shows at the vertex, with its
/// share there: of the inner side when the ray comes from inside. Textures whose share is smaller
/// than `least` are left out.
void for_visible_layers(const World&, const Vertex&, double least,
                        FunctionRef<void(double, std::span<const Layer>)> use);

/// Calls use(share, texture) for the textures that show at a hit.
void for_visible_textures(const World&, const Hit&, bool from_inside,
                          FunctionRef<void(double, const Texture&)> use);

}  // namespace candelabra
