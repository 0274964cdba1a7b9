// SPDX-License-Identifier: GPL-3.0-or-later
// Materials of a world that is being compiled: one for all primitives of the same appearance, and
// those of mesh faces. Used by flatten().
#pragma once

#include "world/world.h"

#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace candelabra {

/// Flags for the kinds of rays that do not see an object. Also a mask of these flags.
struct Hidden {
    bool no_shadow = false, no_image = false, no_reflection = false, no_radiosity = false;

    friend Hidden operator|(Hidden a, Hidden b) {
        return {a.no_shadow || b.no_shadow, a.no_image || b.no_image,
                a.no_reflection || b.no_reflection, a.no_radiosity || b.no_radiosity};
    }
    friend Hidden operator&(Hidden a, Hidden b) {
        return {a.no_shadow && b.no_shadow, a.no_image && b.no_image,
                a.no_reflection && b.no_reflection, a.no_radiosity && b.no_radiosity};
    }
};

/// In POV-Ray the flags of a whole solid take effect; only some solids heed those of their parts.
inline Hidden heeded_in(Csg csg) {
    return {false, csg == Csg::merge, csg == Csg::merge || csg == Csg::together};
}

/// Attributes that an object inherits from the unions around it. Handles are referred to in place:
/// counting references for each of a million objects takes longer than everything else.
struct Inherited : Hidden {
    Hidden said = {};                          ///< given for the object and the unions around it
    Hidden heeded = {true, true, true};        ///< flags that take effect if given for parts
    Handle<Transform> transform;               ///< null: none
    const Handle<Texture>* texture = nullptr;  ///< in world space
    const Handle<Texture>* inner = nullptr;    ///< the same for the inner side; null: as outside
    const Handle<Interior>* interior = nullptr;
    std::uint32_t light_group = 0;
    bool named_group = false;           ///< a light group here has a declared name
    std::uint32_t shared_interior = 0;  ///< see Material
    bool no_luminaire = false, double_illuminate = false, hollow = false, uv = false;
    PhotonSurface photons = {};
    /// Whether this is one of the parts of a composite. As in POV-Ray, a part with its own interior
    /// is a solid of its own: a ray that enters it does not leave it through the others.
    bool of_several = false;
    /// The lamp around it whose flux is stated: its number in StatedLamps, 0: none; its data.
    std::uint32_t lamp = 0;
    const Handle<LampData>* lamp_data = nullptr;
    bool all_of_lamp = false;  ///< nothing of the lamp has an emission of its own, so all glows
};

class Materials {
public:
    /// The world must outlive this.
    explicit Materials(World& world) : world_(world) {}

    /// Returns the texture in world space: it moves with the unions around its object, but not on u
    /// and v. Plain colours look the same everywhere and are not copied.
    const Handle<Texture>& world_texture(const Handle<Texture>& texture,
                                         const Handle<Transform>& transform, bool uv);

    /// The same for the media of an interior.
    const Handle<Interior>& world_interior(const Handle<Interior>&,
                                           const Handle<Transform>& transform);

    /// Returns the material of primitives with these attributes.
    std::uint32_t index(const Inherited& look);
    /// Returns a copy of a material for a mesh alone, which distinguishes the mesh from other
    /// solids.
    std::uint32_t own(std::uint32_t material);
    /// Materials of a mesh whose faces have textures: its own, then those of the textures. All
    /// belong to one solid.
    std::vector<std::uint32_t> of_faces(const Object& mesh, const Inherited& look,
                                        const Handle<Transform>& outside);
    /// Returns the material of a mesh's face, given the numbers of its corners' textures and the
    /// materials of the mesh.
    std::uint32_t of_face(const std::vector<std::uint32_t>& materials, const Face& looks);
    /// Returns the material of a surface that is one primitive, and lists the textures of its
    /// parts.
    std::uint32_t of_parts(const Object& object, const Inherited& look,
                           const Handle<Transform>& outside, TextureList& list);

    /// Whether primitives of the material are luminaires.
    bool glows(std::uint32_t material) const { return glows_[material]; }
    /// The lamp that a finish of the material states; null: none.
    const Handle<LampData>& lamp(std::uint32_t material) const { return lamps_[material]; }
    /// Whether the material has an emission, whatever it lights.
    bool emits(std::uint32_t material) const { return emits_[material]; }

private:
    /// The attributes that define a material.
    struct Key {
        const Texture* texture;
        const Texture* inner;
        const Interior* interior;
        std::uint32_t light_group, shared_interior;
        bool no_shadow, no_image, no_reflection, no_radiosity, no_luminaire, double_illuminate,
            hollow;
        PhotonSurface photons;
        const LampData* lamp;
        bool all_of_lamp;

        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Hash {
        std::size_t operator()(const Key&) const;
    };
    using TextureKey = std::tuple<const Texture*, const Transform*, bool>;

    void add(const Inherited& look);
    Handle<Texture> lit(const Handle<Texture>&, const Inherited&) const;
    void include(std::uint32_t material, std::uint32_t part);

    World& world_;
    std::vector<bool> glows_, emits_;
    std::vector<Handle<LampData>> lamps_;
    std::unordered_map<Key, std::uint32_t, Hash> indices_;
    std::optional<Key> last_key_;
    std::uint32_t last_ = 0;  ///< of last_key_
    std::map<TextureKey, Handle<Texture>> textures_;
    std::map<std::pair<const Interior*, const Transform*>, Handle<Interior>> interiors_;
    // Kept so that no address in textures_ and interiors_ is reused.
    std::vector<Handle<Transform>> kept_transforms_;
    std::vector<Handle<Texture>> kept_textures_;
    std::vector<Handle<Interior>> kept_interiors_;
    std::map<std::pair<std::uint32_t, Face>, std::uint32_t> blended_;  ///< by mesh
};

}  // namespace candelabra
