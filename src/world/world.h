// SPDX-License-Identifier: GPL-3.0-or-later
// A compiled scene: what rays can meet. Immutable once compile() has made it, so any number of
// threads may ask it.
#pragma once

#include "backdrop/sky_light.h"
#include "base/short_list.h"
#include "camera/camera.h"
#include "index/wide_tree.h"
#include "lighting/sampler.h"
#include "scene/scene.h"
#include "shape/part_index.h"
#include "world/sources.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

class ReadyRay;

using PrimitiveIndex = std::uint32_t;
inline constexpr PrimitiveIndex no_primitive = ~PrimitiveIndex{0};

/// What a ray is inside of, in the order of entering.
using EnteredSolids = ShortList<PrimitiveIndex, 6>;

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
    bool double_illuminate = false;
    bool hollow = false;
    bool uv = false;                  ///< a texture asks for u and v
    Handle<Texture> inner = nullptr;  ///< of the side that is seen from inside; null: as outside
    std::uint32_t light_group = 0;    ///< in WorldLights::groups; 0: none
    /// Number of the union that gave its interior to all of its parts: rays take them for one solid
    /// that they enter and leave in turn, as in POV-Ray. 0: the interior is its own.
    std::uint32_t shared_interior = 0;
    std::uint32_t solid = 0;  ///< tells faces of one mesh from those of others; see World::solid()

    /// Nothing behind it is lit.
    bool stops_light() const { return !transparent && !no_shadow; }
};

struct SpherePrimitive {
    Vec3 centre;
    double radius;
};

struct TrianglePrimitive {
    Vec3 corner1, corner2, corner3;
};

/// Normals of a smooth triangle's corners.
struct CornerNormals {
    Vec3 normal1, normal2, normal3;
};

/// Textures of the parts of a surface, by the numbers that the shape has for them.
using TextureList = std::vector<Handle<Texture>>;

/// A primitive of any other shape, under any affine map.
struct PlacedShape {
    BuiltShape shape;
    Handle<Transform> transform;  ///< null: none
    Box box;                      ///< around it; infinite for planes and the like
};

/// A plane in world space, which every ray asks.
struct EndlessPlane {
    Vec3 normal;  ///< unit
    double distance;
    PrimitiveIndex primitive;

    /// Where the ray meets it; not a number when it never does.
    double meet(const Ray& ray) const {
        const double approach = dot(ray.direction, normal);
        return approach == 0 ? std::numeric_limits<double>::quiet_NaN()
                             : (distance - dot(ray.origin, normal)) / approach;
    }
};

/// Several shapes as one solid. Its leaves are primitives as well, one after the other.
struct PlacedComposite {
    Handle<Composite> composite;
    PrimitiveIndex first_leaf = 0;
    bool transparent = false;  ///< a leaf is
    Box around;  ///< out of this no ray begins inside of it, as of what is inverse in POV-Ray
};

/// Solids that rays must know of by where they are, for cameras whose rays begin anywhere.
struct ClearSolids {
    std::vector<std::uint32_t> unbounded;
    std::vector<std::uint32_t> bounded;  ///< in the order of the index's parts
    PartIndex index;
};

/// Objects that are lit by the same lights.
struct LightGroup {
    std::uint32_t outer = 0;    ///< another group whose lights light it as well; 0: none
    bool global_lights = true;  ///< lights of no group light its objects
};

/// What restricts a light.
struct LightReach {
    std::uint32_t group = 0;             ///< it lights the objects of this group only; 0: all
    Handle<Composite> window = nullptr;  ///< it lights what is seen through this; null: all
};

/// Where surfaces are.
struct Geometry {
    /// Number of the first shape among the primitives.
    PrimitiveIndex shapes_begin() const {
        return static_cast<PrimitiveIndex>(spheres.size() + triangles.size());
    }

    /// Number of the first leaf of a composite among the primitives. The tree and `unbounded` have
    /// the composites themselves from this number on.
    PrimitiveIndex leaves_begin() const {
        return shapes_begin() + static_cast<PrimitiveIndex>(shapes.size());
    }

    // Primitives are counted through: spheres, then triangles, then shapes, then leaves.
    std::vector<SpherePrimitive> spheres;
    std::vector<TrianglePrimitive> triangles;
    std::vector<PlacedShape> shapes;
    std::vector<PlacedComposite> composites;
    std::vector<std::uint32_t> composite_of;  ///< of the leaves
    std::vector<CornerNormals> normals;       ///< of the smooth triangles
    /// Per triangle: index in normals, or no_primitive; empty when none is smooth.
    std::vector<std::uint32_t> normals_of;
    std::vector<std::array<Vec2, 3>> uvs;  ///< of the corners of some triangles
    /// Per triangle: index in uvs, or no_primitive; the last ones are left out when they have none.
    std::vector<std::uint32_t> uvs_of;
    /// Planes and the like, asked apart from the tree; ascending.
    std::vector<std::uint32_t> unbounded;
    std::vector<EndlessPlane> planes;    ///< those of them that are planes in their own place
    std::vector<std::uint32_t> endless;  ///< the others
    WideTree tree;
    ClearSolids clear_solids;  ///< empty unless the camera is parallel
};

/// How surfaces look.
struct Appearance {
    std::vector<Material> materials;
    std::vector<std::uint32_t> material_of;  ///< per primitive
    /// Of faces of meshes that are leaves, and of components of blobs.
    std::unordered_map<PrimitiveIndex, TextureList> part_textures;
    bool any_transparent = false;  ///< rays must know what they are inside of
    bool any_left_out = false;     ///< some objects are not there for some rays
    bool any_scattering = false;   ///< a finish has facets
    bool any_clear = false;        ///< shadow rays may pass through something
};

/// What gives light, except for the sky.
struct WorldLights {
    std::vector<Luminaire> luminaires;
    /// Per primitive: index in luminaires, or no_primitive; empty if none glows.
    std::vector<std::uint32_t> luminaire_of;
    BuiltLightSampler sampler;  ///< among the luminaires
    std::vector<Light> sources;
    std::vector<LightReach> reach;       ///< of each source
    std::vector<SourceSet> source_sets;  ///< all sources
    std::vector<LightGroup> groups{1};   ///< the first stands for what is in none
};

/// What rays meet where they meet no surface, and on their way.
struct Sky {
    Background background;
    std::optional<SkySphere> sphere;
    std::vector<Fog> fogs;
    std::vector<Rainbow> rainbows;
    SkyLight light;  ///< empty unless the sky is a luminaire
};

/// From where the world is seen.
struct WorldView {
    Projection camera;
    Bump camera_normal;
};

/// What holds for the whole scene.
struct Rules {
    GlobalSettings settings;
    double language_version = 3.7;
    int quality = 9;  ///< see surface/simplified.h
};

/// Which parts of the scene's text made what.
struct Provenance {
    /// The statements of the scene that made luminaires and lights, and which one made each of
    /// them.
    std::vector<Span> light_statements;
    std::vector<std::uint32_t> statement_of_luminaire, statement_of_light;
    /// Which object each primitive belongs to, by its place in object_spans: objects are counted as
    /// the scene makes them. Both are empty unless compile() was asked to remember.
    std::vector<std::uint32_t> object_of;
    std::vector<Span> object_spans;
    std::size_t object_count = 0;  ///< as the scene counts them
};

/// Where a ray met a surface.
struct Hit {
    PrimitiveIndex primitive = no_primitive;
    std::uint32_t part = 0;  ///< of shapes and leaves: see Crossing
    Vec3 position = Vec3(0);
    Vec3 normal = Vec3(0);         ///< unit, outward: of the surface as it is
    Vec3 smooth_normal = Vec3(0);  ///< unit, outward: of the surface as it is shaded
    double tolerance =
        0;  ///< rays that start here begin this far away, to miss the surface they come from
};

/// Who asks: some objects are left out for some rays.
enum class RayKind { camera, reflected, light, gathering };

class World {
public:
    World() = default;
    World(World&&) = default;  ///< not copied: the sampler looks at the luminaires where they are
    World& operator=(World&&) = default;

    /// The nearest surface further than `tolerance` along the ray, whose direction has length 1.
    bool first_hit(const Ray&, double tolerance, RayKind, Hit&) const;

    /// The share of light that gets from a hit to a point at that distance along the ray, per
    /// channel: 0 when something opaque is between. What lies within the tolerance of either end
    /// does not count, nor do clear surfaces that are `apart` or less behind another or from an
    /// end. Light that starts in solids, which are `around` it, leaves these first.
    Vec3 transmittance(const Ray&, double tolerance, double distance,
                       std::span<const PrimitiveIndex> around = {}, double apart = 0) const;

    /// What the surface that a ray hits leaves of the light from behind it, per channel.
    Vec3 passed(const Hit&, const Ray&) const;

    /// Whether rays must know that they are inside of a primitive, or of a composite by its number
    /// from leaves_begin() on: it is transparent, has an interior, or keeps out the fog that there
    /// is.
    bool is_noted_solid(std::uint32_t item) const;
    /// Whether there may be such solids.
    bool notes_solids() const { return appearance.any_transparent || has_air(); }
    /// Whether there is fog or a rainbow.
    bool has_air() const { return !sky.fogs.empty() || !sky.rainbows.empty(); }

    /// Whether the point is inside a primitive, or inside the composite that it is a leaf of.
    bool contains_point(PrimitiveIndex, const Vec3&) const;
    /// The noted solids that the point lies inside of, by a primitive of each.
    EnteredSolids containing(const Vec3&) const;

    const Material& material(PrimitiveIndex primitive) const {
        return appearance.materials[appearance.material_of[primitive]];
    }

    /// Radiance that the primitive emits at a point of its surface.
    Vec3 emission(PrimitiveIndex, const Vec3& point) const;

    /// Calls use(share, texture) for each texture that shows at a point of the surface: one, or
    /// those of the corners of a mesh's face, or of a blob's components. The shares add up to 1.
    /// `part` is the hit's, or any_part.
    void for_textures(PrimitiveIndex, std::uint32_t part, const Vec3& point,
                      FunctionRef<void(double, const Texture&)> use) const;

    /// Where the point is on a picture that is wrapped around the surface.
    Vec2 uv(PrimitiveIndex, std::uint32_t part, const Vec3& point) const;

    /// What comes from a direction in which there is nothing.
    Vec3 sky_radiance(const Vec3& direction) const {
        return sky_radiance(direction, sky.background.radiance());
    }
    /// The same with that light of the background.
    Vec3 sky_radiance(const Vec3& direction, const Vec3& behind) const;

    /// How clear it is there, 0 to 1, in a picture with alpha: POV-Ray 3.7's rules.
    double sky_clear(const Vec3& direction) const;

    /// Whether the lights of a group may light an object of the material.
    bool reaches(std::uint32_t light_group, const Material&) const;

    /// Whether it is left to chance which lights are asked at a point.
    bool light_is_drawn() const;

    /// The share of a surface of this colour that is not transparent, by the scene's language
    /// version.
    double opacity(const Colour&) const;

    /// What all patterns of the scene have in common, for a point that is on no surface.
    PatternScene pattern_scene() const {
        return {noise_generator(rules.settings.noise_generator), rules.settings.number_of_waves,
                nullptr};
    }

    /// The same for a point of a surface, without how it is seen.
    PatternScene pattern_scene(PrimitiveIndex primitive, std::uint32_t part,
                               const Vec3& point) const {
        PatternScene scene = pattern_scene();
        if (material(primitive).uv) scene.uv = uv(primitive, part, point);
        return scene;
    }

    /// What rays into a solid are told apart by: all faces of a mesh are one solid, and so are all
    /// leaves of a composite, and all parts of a union that share its interior.
    std::uint32_t solid(PrimitiveIndex primitive) const {
        constexpr std::uint32_t above_all = 0x80000000;
        if (const std::uint32_t number = material(primitive).shared_interior)
            return above_all - number;
        const bool face =
            primitive >= geometry.spheres.size() && primitive < geometry.shapes_begin();
        if (primitive >= geometry.leaves_begin())
            return geometry.leaves_begin() +
                   geometry.composite_of[primitive - geometry.leaves_begin()];
        return face ? ~material(primitive).solid : primitive;
    }

    /// Whether two samples of one point of the picture may differ.
    bool left_to_chance() const {
        return light_is_drawn() || !sky.light.empty() || appearance.any_scattering ||
               !shutter.empty() || std::holds_alternative<PathTraced>(rules.settings.integrator);
    }

    Geometry geometry;
    Appearance appearance;
    WorldLights lights;
    Sky sky;
    WorldView view;
    Rules rules;
    Provenance provenance;
    std::vector<World> shutter;  ///< the scene at later times while the camera's shutter is open

private:
    struct Candidate {
        double t;
        PrimitiveIndex primitive = no_primitive;
        Vec3 normal = Vec3(0);            ///< of shapes and leaves only
        std::uint32_t part = 0;           ///< of shapes and leaves only: see Crossing
        double weight2 = 0, weight3 = 0;  ///< of triangles only
    };
    /// A point where light passes through a transparent surface.
    struct Passage {
        double t;
        PrimitiveIndex primitive;
        Vec3 normal;  ///< of any length
        std::uint32_t part = 0;
    };
    using Passages = ShortList<Passage, 8>;  ///< from the first to the last, when all are there
    /// Adds a noted solid, if the point is in it: a composite by the leaf whose interior it has.
    void add_if_inside(std::uint32_t item, const Vec3& point, EnteredSolids&) const;
    /// A leaf of a composite, by its number among all leaves.
    const CompositeLeaf& leaf(std::uint32_t) const;
    void meet(PrimitiveIndex, ReadyRay&, const Interval&, Candidate&) const;
    void meet_shape(PrimitiveIndex, const Ray&, const Interval&, Candidate&) const;
    template <class Wanted>
    void meet_composite(std::uint32_t composite, const Ray&, const Interval&, Candidate&,
                        Wanted) const;
    bool left_out(PrimitiveIndex, RayKind) const;
    Hit complete(const Ray&, const Candidate&) const;
    void collect(std::uint32_t item, const Ray&, const Interval&, Passages&) const;
    Vec3 passed(const Passage&, const Ray&) const;
    void keep_apart(Passages&, const Ray&, double distance, double apart) const;
    Vec3 dimmed(const Passages&, std::span<const PrimitiveIndex> around) const;
    bool opaque_between(std::uint32_t item, ReadyRay&, const Interval&) const;
    bool may_pass(std::uint32_t item) const;
};
