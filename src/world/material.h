// SPDX-License-Identifier: GPL-3.0-or-later
// How the surfaces of a world look, and what they do to rays. Filled by flatten().
#pragma once

#include "medium/interior.h"
#include "surface/texture.h"
#include "world/geometry.h"
#include "world/photon_targets.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace candelabra {

/// The look of some primitives and what they do to rays; many primitives share one.
struct Material {
    Handle<Texture> texture;  ///< in world space; never null
    /// Of the other corners of a mesh's face, when they differ; null: the whole shows the one
    /// above.
    Handle<Texture> texture2 = {}, texture3 = {};
    Handle<Interior> interior;  ///< null: the atmosphere's
    bool transparent = false;   ///< light can pass through it
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool no_radiosity = false;
    bool double_illuminate = false;
    bool hollow = false;
    bool other_light = false;  ///< what it sends to other surfaces is more than diffuse reflection
    bool uv = false;           ///< a texture asks for u and v
    bool by_view = false;      ///< a pattern depends on the direction of the ray
    Handle<Texture> inner = nullptr;  ///< of the side that is seen from inside; null: as outside
    std::uint32_t light_group = 0;    ///< in WorldLights::groups; 0: none
    /// Number of the union that gave its interior to all of its parts: rays take them for one solid
    /// that they enter and leave in turn, as in POV-Ray. 0: the interior is its own.
    std::uint32_t shared_interior = 0;
    PhotonSurface photons = {};
    std::uint32_t solid = 0;  ///< tells faces of one mesh from those of others; see World::solid()

    /// Nothing behind it is lit.
    bool stops_light() const { return !transparent && !no_shadow; }
};

/// Textures of the parts of a surface, by the numbers that the shape has for them.
using TextureList = std::vector<Handle<Texture>>;

/// How surfaces look.
struct Appearance {
    std::vector<Material> materials;
    std::vector<std::uint32_t> material_of;  ///< per primitive
    /// Of faces of meshes that are leaves, and of components of blobs.
    std::unordered_map<PrimitiveIndex, TextureList> part_textures;
    bool any_transparent = false;  ///< rays must know what they are inside of
    bool any_left_out = false;     ///< some objects are not there for some rays
    bool any_scattering = false;   ///< a finish has facets
    bool any_media = false;        ///< there are media in a solid
    bool any_drawn_media = false;  ///< and samples of them differ
    bool any_other_light = false;  ///< see World::has_other_light()
    bool any_clear = false;        ///< shadow rays may pass through something
};

}  // namespace candelabra
