// SPDX-License-Identifier: GPL-3.0-or-later
// A compiled scene, for ray queries. compile() makes it, and nobody changes it afterwards: any
// number of threads may use it. What depends on the camera is in a Shot (world/shot.h).
#pragma once

#include "base/rgb.h"
#include "camera/camera.h"
#include "scene/scene.h"
#include "world/facts.h"
#include "world/hit.h"
#include "world/lights.h"
#include "world/material.h"
#include "world/photon_targets.h"
#include "world/provenance.h"
#include "world/sky.h"

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace candelabra {

/// The camera, and the settings of its film.
struct WorldView {
    Projection camera;
    Bump camera_normal;
    FilmSettings film = {};
};

/// Settings of the whole scene.
struct Rules {
    GlobalSettings settings;
    double language_version = 3.7;
    int quality = 9;  ///< see surface/quality.h
};

/// Maximum number of surfaces that a ray passes in a straight line: more are rounding errors, or do
/// not matter.
inline constexpr int max_surfaces_along = 1000;

class World {
public:
    World() = default;
    explicit World(const World&) = default;  ///< explicit, as scenes are large
    World(World&&) = default;
    World& operator=(World&&) = default;

    // Ray queries: ray_queries.cpp

    /// Finds the nearest surface farther than `tolerance` along the ray, whose direction has length
    /// 1.
    bool first_hit(const Ray&, double tolerance, RayKind, Hit&) const;

    /// Calls visit(hit, distance) for the surfaces that the ray meets farther than `from`, nearest
    /// first, until a call returns false. A visit that takes a Hit& may raise its tolerance: the
    /// next surface is farther behind the hit than that. Returns whether no call returned false.
    template <class Visit>
    bool along(const Ray& ray, double from, RayKind kind, Visit visit) const {
        Hit hit;
        for (int met = 0; met < max_surfaces_along; ++met) {
            if (!first_hit(ray, from, kind, hit)) return true;
            const double distance = dot(hit.position - ray.origin, ray.direction);
            if (!visit(hit, distance)) return false;
            from = distance + hit.tolerance;
        }
        return true;
    }

    // Shadow rays: shadow.cpp

    /// Transmittance from a hit to a point at that distance along the ray, per channel: 0 if
    /// something opaque is in between. Surfaces within the tolerance of either end do not count,
    /// nor do clear surfaces that are `apart` or less behind another one or from an end. Light that
    /// starts inside of the solids `around` leaves these first. Media do not count.
    Rgb transmittance(const Ray&, double tolerance, double distance,
                      std::span<const PrimitiveIndex> around = {}, double apart = 0) const;

    /// The distances about the end of a light's way at which transmittance() leaves out surfaces.
    static Interval end_of_way(double tolerance, double distance) {
        constexpr double relative = 1e-7;
        const double apart = relative * distance + tolerance;
        return {std::max(distance - apart, tolerance), distance + apart};
    }

    /// Takes a part of a light's way between two surfaces, and the solids that contain it.
    using UseStretch = FunctionRef<void(const Interval&, std::span<const PrimitiveIndex>)>;
    /// Takes a surface and the solids that contain the way in front of it; returns the fraction of
    /// light that passes, per channel.
    using UseSurface = FunctionRef<Rgb(const Hit&, std::span<const PrimitiveIndex>)>;
    struct Shade {
        std::span<const PrimitiveIndex> around = {};
        double apart = 0;
        const UseStretch* stretches = nullptr;  ///< null: not wanted
        /// Asked about materials that keep energy; null: passed() holds for them, too.
        const UseSurface* surfaces = nullptr;
    };
    /// The same, and calls `stretches` for each part of the way if light passes. Objects that cast
    /// no shadow are ignored.
    Rgb transmittance(const Ray&, double tolerance, double distance, const Shade&) const;

    // Solids: solids.cpp

    /// Whether rays must track that they are inside of an item, because it is transparent, has an
    /// interior, or keeps out fog or media.
    bool is_noted_solid(std::uint32_t item) const;
    /// Whether the point is inside a primitive, or inside the composite that it is a leaf of.
    bool contains_point(PrimitiveIndex, const Vec3&) const;
    /// Returns the noted solids that contain the point, one primitive of each.
    EnteredSolids containing(const Vec3&) const;
    /// Updates the solids of a ray that passes a surface of the primitive: the ray leaves the
    /// primitive's solid if it is inside, and enters it otherwise.
    Passing pass(PrimitiveIndex, EnteredSolids&) const;

    /// Number that identifies a solid for rays: all faces of a mesh are one solid, and so are all
    /// leaves of a composite, and all parts of a union that share its interior.
    std::uint32_t solid(PrimitiveIndex) const;

    // Appearance: looks.cpp

    const Material& material(PrimitiveIndex primitive) const {
        const auto& own = appearance.material_of;
        return appearance
            .materials[primitive < own.size() ? own[primitive] : instanced_material(primitive)];
    }
    /// The index of a material of an instance's primitive.
    std::uint32_t instanced_material(PrimitiveIndex) const;

    /// Index of the primitive's luminaire; no_primitive if there is none. Media inside of a
    /// primitive do not count as its own luminaire.
    std::uint32_t luminaire_of(PrimitiveIndex primitive) const {
        const auto& own = lights.luminaire_of;
        return primitive < own.size() ? own[primitive] : instanced_luminaire(primitive);
    }
    /// The same for an instance's primitive, and where no primitive has one.
    std::uint32_t instanced_luminaire(PrimitiveIndex) const;

    /// Radiance that one side of the primitive emits at a point of its surface in a direction, a
    /// unit vector away from it; null: in the brightest direction. Patterns do not know how the
    /// surface faces.
    Rgb emission(PrimitiveIndex, const Vec3& point, Side, const Vec3* direction = nullptr) const;
    /// The same where they know it.
    Rgb emission(const SeenPoint&, const Vec3& direction) const;

    /// Factor by which the primitive emits more than its textures say in that direction; null: the
    /// greatest one.
    double output(PrimitiveIndex primitive, const Vec3* direction) const {
        if (primitive >= appearance.output_of.size()) return 1;
        const LightOutput& found = appearance.outputs[appearance.output_of[primitive]];
        if (!found.web) return found.scale;
        return found.scale * (direction ? found.web->factor(*direction) : found.web->greatest());
    }

    /// Takes the share of a texture, the texture, and where the space of the texture is placed;
    /// null: it is that of the world.
    using UseTexture = FunctionRef<void(double, const Texture&, const Transform* place)>;
    /// Calls `use` for each texture that shows on that side at a point of the surface: a single
    /// one, or those of the corners of a mesh's face or of a blob's components. The shares add up
    /// to 1. `part` is that of the hit, or any_part.
    void for_textures(PrimitiveIndex, std::uint32_t part, const Vec3& point, Side,
                      UseTexture use) const;

    /// Returns the point's coordinates on a picture that is wrapped around the surface.
    Vec2 uv(PrimitiveIndex, std::uint32_t part, const Vec3& point) const;

    /// Fraction of the light from behind that the surface at a hit transmits, per channel.
    Rgb passed(const Hit&, const Ray&) const;

    /// Opacity of a surface of this colour, by the rules of the scene's language version.
    double opacity(const Colour&) const;

    /// Settings that all patterns of the scene share, for a point on no surface.
    PatternScene pattern_scene() const {
        return {noise_generator(rules.settings.noise_generator), rules.settings.number_of_waves,
                nullptr};
    }

    /// The same for a point of a surface, without the viewing direction.
    PatternScene pattern_scene(PrimitiveIndex primitive, std::uint32_t part,
                               const Vec3& point) const {
        PatternScene scene = pattern_scene();
        if (material(primitive).uv) scene.uv = uv(primitive, part, point);
        return scene;
    }

    /// The same for a point that is seen from a side, by its geometric normal. `axes` outlives the
    /// result.
    PatternScene pattern_scene(const SeenPoint&, SurfaceAxes& axes) const;

    // The sky: sky.cpp

    /// Radiance from a direction without surfaces.
    Rgb sky_radiance(const Vec3& direction) const {
        return sky_radiance(direction, sky.background.radiance());
    }
    /// The same with that radiance of the background.
    Rgb sky_radiance(const Vec3& direction, const Rgb& behind) const;

    /// Radiance of the sun's disc, which is a light source, and so no part of the light of the sky.
    Rgb sun_radiance(const Vec3& direction) const;

    /// Transparency of the sky in that direction, 0 to 1, for a picture with alpha: POV-Ray 3.7's
    /// rules.
    double sky_clear(const Vec3& direction) const;

    // Light groups: light_groups.cpp

    /// Whether the lights of a group may light an object of the material.
    bool reaches(std::uint32_t light_group, const Material&) const;

    Geometry geometry;
    Appearance appearance;
    WorldLights lights;
    Sky sky;
    WorldView stated_view;  ///< as the scene states it; each Shot has its own
    Rules rules;
    std::vector<PhotonTarget> photon_targets;  ///< empty: no photons
    Provenance provenance;
    WorldFacts facts;
    std::vector<World> shutter;  ///< the scene at later times while the camera's shutter is open
};

/// A world that is complete. All that refer to it keep it.
using SharedWorld = std::shared_ptr<const World>;

}  // namespace candelabra
