// SPDX-License-Identifier: GPL-3.0-or-later
// The materials of a world while it is compiled: one for all primitives that look the same, and
// those of mesh faces. Used by flatten().
#pragma once

#include "world/world.h"

#include <map>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace candelabra {

/// Who does not see an object; or to whom this is said, or heeded.
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

/// POV-Ray asks a solid as a whole which rays see it; only some heed their parts.
inline Hidden heeded_in(Csg csg) {
    return {false, csg == Csg::merge, csg == Csg::merge || csg == Csg::together};
}

/// What an object has from the unions around it. Handles are referred to where they are: counting
/// their holders for each of a million objects takes longer than all else.
struct Inherited : Hidden {
    Hidden said = {};                          ///< of the object and of what it is part of
    Hidden heeded = {true, true, true};        ///< when it is said of parts of this
    Handle<Transform> transform;               ///< null: none
    const Handle<Texture>* texture = nullptr;  ///< in world space
    const Handle<Texture>* inner = nullptr;    ///< likewise, of the inner side; null: as outside
    const Handle<Interior>* interior = nullptr;
    std::uint32_t light_group = 0;
    bool named_group = false;           ///< a light group here comes by a declared name
    std::uint32_t shared_interior = 0;  ///< see Material
    bool no_luminaire = false, double_illuminate = false, hollow = false, uv = false;
    PhotonSurface photons = {};
    /// One of the parts of a composite. As in POV-Ray, a part with an interior of its own is a
    /// solid of its own: a ray that enters it does not leave it through the others.
    bool of_several = false;
};

class Materials {
public:
    /// The world outlives this.
    explicit Materials(World& world) : world_(world) {}

    /// A texture moves with the unions around its object; on u and v it does not. Plain colours
    /// look the same everywhere and are not copied.
    const Handle<Texture>& world_texture(const Handle<Texture>& texture,
                                         const Handle<Transform>& transform, bool uv);

    /// The same for the media in an interior.
    const Handle<Interior>& world_interior(const Handle<Interior>&,
                                           const Handle<Transform>& transform);

    /// The material of primitives that look so.
    std::uint32_t index(const Inherited& look);
    /// A copy of a material that nothing else has: it tells a mesh from other solids.
    std::uint32_t own(std::uint32_t material);
    /// Of a mesh whose faces have textures: its own, then those of its textures. All are one solid.
    std::vector<std::uint32_t> of_faces(const Object& mesh, const Inherited& look,
                                        const Handle<Transform>& outside);
    /// The material of a mesh's face, by the numbers of its corners' textures; `materials` are the
    /// mesh's.
    std::uint32_t of_face(const std::vector<std::uint32_t>& materials, const Face& looks);
    /// The material of a surface that is one primitive, and the textures of its parts.
    std::uint32_t of_parts(const Object& object, const Inherited& look,
                           const Handle<Transform>& outside, TextureList& list);

    /// Whether primitives of the material light others.
    bool glows(std::uint32_t material) const { return glows_[material]; }

private:
    /// What primitives of one material have in common.
    struct Key {
        const Texture* texture;
        const Texture* inner;
        const Interior* interior;
        std::uint32_t light_group, shared_interior;
        bool no_shadow, no_image, no_reflection, no_radiosity, no_luminaire, double_illuminate,
            hollow;
        PhotonSurface photons;

        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Hash {
        std::size_t operator()(const Key&) const;
    };
    using TextureKey = std::tuple<const Texture*, const Transform*, bool>;

    void add(const Inherited& look);
    Handle<Texture> lit(const Handle<Texture>&) const;
    void include(std::uint32_t material, std::uint32_t part);

    World& world_;
    std::vector<bool> glows_;
    std::unordered_map<Key, std::uint32_t, Hash> indices_;
    std::optional<Key> last_key_;
    std::uint32_t last_ = 0;  ///< of that key
    std::map<TextureKey, Handle<Texture>> textures_;
    std::map<std::pair<const Interior*, const Transform*>, Handle<Interior>> interiors_;
    // Kept so that no address in textures_ and interiors_ is used twice.
    std::vector<Handle<Transform>> kept_transforms_;
    std::vector<Handle<Texture>> kept_textures_;
    std::vector<Handle<Interior>> kept_interiors_;
    std::map<std::pair<std::uint32_t, Face>, std::uint32_t> blended_;  ///< by mesh
};

}  // namespace candelabra
