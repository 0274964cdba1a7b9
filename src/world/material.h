// SPDX-License-Identifier: GPL-3.0-or-later
// The appearance of a world's surfaces, and their effect on rays. Filled by flatten().
#pragma once

#include "luminaire/body_web.h"
#include "medium/interior.h"
#include "surface/texture.h"
#include "world/geometry.h"
#include "world/photon_targets.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace candelabra {

/// Appearance of some primitives, and their effect on rays; many primitives share one.
struct Material {
    Handle<Texture> texture;  ///< in world space; never null
    /// For the other corners of a mesh's face, if they differ; null: the whole face shows
    /// `texture`.
    Handle<Texture> texture2 = {}, texture3 = {};
    Handle<Interior> interior;  ///< null: the atmosphere's
    bool transparent = false;   ///< whether light can pass through
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool no_radiosity = false;
    bool double_illuminate = false;
    bool hollow = false;
    bool keeps_energy = false;  ///< whether a layer takes what it reflects from what passes
    bool other_light = false;   ///< whether it sends more than diffuse reflection to other surfaces
    bool lit_from_behind = false;  ///< whether a side shows light that comes to the other
    bool uv = false;               ///< whether a texture needs u and v
    bool by_axes = false;       ///< whether a texture needs SurfaceAxes
    bool by_view = false;       ///< whether a pattern depends on the direction of the ray
    bool by_surface = false;    ///< whether a pattern depends on how the surface faces
    Handle<Texture> inner = nullptr;  ///< of the inner side; null: as outside
    std::uint32_t light_group = 0;    ///< in WorldLights::groups; 0: none
    /// Number of the union that gave its interior to all of its parts: rays treat these as one
    /// solid, which they enter and leave in turn, as in POV-Ray. 0: the interior is not shared.
    std::uint32_t shared_interior = 0;
    PhotonSurface photons = {};
    std::uint32_t solid = 0;  ///< tells faces of one mesh from those of others; see World::solid()

    /// Whether nothing behind it is lit.
    bool stops_light() const { return !transparent && !no_shadow; }
};

/// What makes the emission of a lamp's textures the light that its data sheet states.
struct LightOutput {
    double scale = 1;               ///< factor of the emission
    Handle<BodyWeb> web = nullptr;  ///< another factor, by direction; null: all alike
};

/// Textures of the parts of a surface, indexed by the shape's numbers of these parts.
using TextureList = std::vector<Handle<Texture>>;

/// Appearance of all surfaces.
struct Appearance {
    std::vector<Material> materials;
    std::vector<std::uint32_t> material_of;  ///< per primitive
    /// For meshes that are leaves, by face, and for blobs, by component.
    std::unordered_map<PrimitiveIndex, TextureList> part_textures;
    /// The first one changes nothing. See World::output().
    std::vector<LightOutput> outputs{1};
    std::vector<std::uint32_t> output_of;  ///< per primitive, in outputs; empty: none has one
    bool any_transparent = false;          ///< rays must track the solids that contain them
    bool any_left_out = false;             ///< some objects are invisible to some rays
    bool any_scattering = false;           ///< a finish has facets
    bool any_media = false;                ///< some solid contains media
    bool any_drawn_media = false;          ///< and samples of these differ
    bool any_other_light = false;          ///< see WorldFacts
    bool any_clear = false;                ///< shadow rays may pass through some surface
    bool any_keeps_energy = false;
    bool any_loose_surface = false;  ///< where rays meet some surface depends on their start
};

}  // namespace candelabra
