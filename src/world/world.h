// SPDX-License-Identifier: GPL-3.0-or-later
// A compiled scene: what rays can meet. Immutable once compile() has made it, so any number of
// threads may ask it.
#pragma once

#include "camera/camera.h"
#include "scene/scene.h"
#include "surface/quality.h"
#include "world/hit.h"
#include "world/lights.h"
#include "world/material.h"
#include "world/photon_targets.h"
#include "world/provenance.h"
#include "world/sky.h"

#include <span>
#include <vector>

namespace candelabra {

class RayConstants;

/// From where the world is seen.
struct WorldView {
    Projection camera;
    Bump camera_normal;
    FilmSettings film = {};
};

/// What holds for the whole scene.
struct Rules {
    GlobalSettings settings;
    double language_version = 3.7;
    int quality = 9;  ///< see surface/quality.h
};

/// Surfaces that a ray passes in a straight line: more are rounding errors, or too many to matter.
inline constexpr int max_surfaces_along = 1000;

class World {
public:
    World() = default;
    World(World&&) = default;  ///< not copied: the sampler looks at the luminaires where they are
    World& operator=(World&&) = default;

    /// The nearest surface further than `tolerance` along the ray, whose direction has length 1.
    bool first_hit(const Ray&, double tolerance, RayKind, Hit&) const;

    /// Calls visit(hit, distance) for the surfaces that the ray meets further than `from`, the
    /// nearest first, while that returns true. A visit that takes a Hit& may raise its tolerance:
    /// the next surface is further behind it than that. Returns whether there was no visit that
    /// returned false.
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

    /// The share of light that gets from a hit to a point at that distance along the ray, per
    /// channel: 0 when something opaque is between. What lies within the tolerance of either end
    /// does not count, nor do clear surfaces that are `apart` or less behind another or from an
    /// end. Light that starts in solids, which are `around` it, leaves these first. Media do not
    /// count.
    Vec3 transmittance(const Ray&, double tolerance, double distance,
                       std::span<const PrimitiveIndex> around = {}, double apart = 0) const;

    /// A part of a light's way between two surfaces, and the solids that it lies in.
    using UseStretch = FunctionRef<void(const Interval&, std::span<const PrimitiveIndex>)>;
    struct Shade {
        std::span<const PrimitiveIndex> around = {};
        double apart = 0;
        const UseStretch* stretches = nullptr;  ///< null: nobody asks
    };
    /// The same, and calls `stretches` for each part of the way if light passes. What casts no
    /// shadow is not there.
    Vec3 transmittance(const Ray&, double tolerance, double distance, const Shade&) const;

    /// What the surface that a ray hits leaves of the light from behind it, per channel.
    Vec3 passed(const Hit&, const Ray&) const;

    /// Whether rays must know that they are inside of an item: it is transparent, has an interior,
    /// or keeps out the fog that there is.
    bool is_noted_solid(std::uint32_t item) const;
    /// Whether there may be such solids.
    bool notes_solids() const {
        return appearance.any_transparent || appearance.any_media || has_air();
    }
    /// Whether rays begin in places of which it must be found out fast what they are in.
    bool indexes_solids() const {
        return view.camera.parallel || !photon_targets.empty() || !lights.volumes.empty();
    }
    /// Whether there is fog, a rainbow or a medium outside of solids.
    bool has_air() const {
        return !sky.fogs.empty() || !sky.rainbows.empty() || !sky.media.empty();
    }
    /// Whether there are participating media anywhere.
    bool has_media() const { return appearance.any_media || !sky.media.empty(); }

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
        if (geometry.is_leaf(primitive)) return geometry.item_of(primitive);
        return geometry.is_triangle(primitive) ? ~material(primitive).solid : primitive;
    }

    /// Whether diffuse surfaces get light from each other, as `radiosity` says.
    bool gathers_light() const {
        return rules.settings.radiosity.on && rules.quality >= quality_full;
    }
    /// Whether light that surfaces reflect lights others.
    bool has_indirect_light() const {
        return gathers_light() || std::holds_alternative<PathTraced>(rules.settings.integrator);
    }

    /// Whether surfaces get other light than that of luminaires by way of diffuse surfaces.
    bool has_other_light() const {
        return appearance.any_other_light || !is_lit_by_luminaires_only();
    }
    /// Whether there are no light sources, sky and media that are lit or shine.
    bool is_lit_by_luminaires_only() const {
        return lights.sources.empty() && !sky.sphere && sky.background.radiance() == Vec3(0) &&
               !has_air() && !has_media();
    }

    /// Whether two samples of one point of the picture may differ.
    bool left_to_chance() const {
        return differs_by_light() || !photon_targets.empty() || appearance.any_drawn_media ||
               std::ranges::any_of(sky.media, &Media::drawn);
    }
    /// The same where media are not asked and no photons fly: these differ less.
    bool differs_by_light() const {
        return light_is_drawn() || !sky.light.empty() || appearance.any_scattering ||
               !shutter.empty() || has_indirect_light();
    }

    Geometry geometry;
    Appearance appearance;
    WorldLights lights;
    Sky sky;
    WorldView view;
    Rules rules;
    std::vector<PhotonTarget> photon_targets;  ///< empty: there are no photons
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
    /// The nearest surface of the item within the range that is nearer than the candidate. Of a
    /// composite those leaves count for which wanted(PrimitiveIndex) is true.
    template <class Wanted>
    void intersect(std::uint32_t item, RayConstants&, const Interval&, Candidate&, Wanted) const;
    bool left_out(PrimitiveIndex, RayKind) const;
    Hit complete(const Ray&, const Candidate&) const;
    void collect(std::uint32_t item, const Ray&, const Interval&, Passages&) const;
    Vec3 passed(const Passage&, const Ray&) const;
    void keep_apart(Passages&, const Ray&, double distance, double apart) const;
    Vec3 dimmed(const Passages&, std::span<const PrimitiveIndex> around) const;
    void for_stretches(const Passages&, std::span<const PrimitiveIndex> around, double distance,
                       const UseStretch&) const;
    bool opaque_between(std::uint32_t item, RayConstants&, const Interval&) const;
    bool may_pass(std::uint32_t item) const;
};

}  // namespace candelabra
