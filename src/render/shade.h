// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface answers light at one point: POV-Ray 3.7's ambient, emission, diffuse, phong and
// specular terms.
#pragma once

#include "world/world.h"

/// Clear surfaces in a row that are looked or shone through; a stop for rays that rounding keeps in
/// one place.
inline constexpr int max_clear_surfaces = 1000;

/// A hit, seen from a direction, with the look of one layer of the surface there.
struct Shading {
    Vec3 position;
    Vec3 view;           ///< unit, direction of the ray that sees it
    Vec3 normal;         ///< unit, as shaded, on the side that is seen
    Vec3 smooth_normal;  ///< unit, as shaded without bumps, on the side that is seen
    Vec3 true_normal;    ///< unit, of the surface as it is, on the side that is seen
    double tolerance = 0;
    const Finish* finish = nullptr;
    const Material* material = nullptr;
    Colour colour;
    double opacity = 1;
    std::span<const PrimitiveIndex> around;  ///< solids that the ray that sees it is in
    bool both_sides = false;
    bool only_shine = false;  ///< diffuse light has been seen to
    double entering = 0;      ///< index of refraction behind the surface, when what is asked is the
                              ///< light that goes in; 0: what comes back
};

/// Calls use(share, texture) for the textures that show at a hit, of the inner side when the ray
/// comes from inside.
void for_textures_seen(const World&, const Hit&, bool from_inside,
                       FunctionRef<void(double, const Texture&)> use);

/// What all layers at a hit have in common.
Shading shading_at(const World&, const Ray&, const Hit&);

/// The same for one layer.
Shading with_layer(const World&, Shading, const Layer&);

/// Where patterns are asked at a hit.
struct SurfacePlace {
    SurfacePlace(const World& world, const Hit& hit, const Shading& s)
        : view{s.position, s.normal, s.view},
          scene(world.pattern_scene(hit.primitive, hit.part, hit.position)) {
        scene.view = &view;
    }
    SurfacePlace(const SurfacePlace&) = delete;
    SurfacePlace& operator=(const SurfacePlace&) = delete;

    SurfaceView view;
    PatternScene scene;
};

/// Whether light from anywhere would change what is seen.
bool answers_light(const Shading&);

/// Radiance that the surface sends to the viewer by itself; `glowing`: with its emission.
Vec3 own_radiance(const World&, const Shading&, bool glowing = true);

/// By what light from a direction, or a reflection towards it, is multiplied where the finish is
/// iridescent.
Vec3 iridescence(const World&, const Shading&, const Vec3& direction);

/// A direction after a mirror with that unit normal.
inline Vec3 mirrored(const Vec3& direction, const Vec3& normal) {
    return direction - 2 * dot(direction, normal) * normal;
}

/// Radiance towards the viewer when light of colour 1 (in POV-Ray's sense: perpendicular irradiance
/// pi) comes from a unit direction; the cosine is in it. Zero where the direction is below the
/// horizon.
/// `grain` is a random number for `crand`, the same for all channels.
Vec3 response(const Shading&, const Vec3& to_light, bool highlights, double grain = 0);

/// Share of unpolarised light that a smooth surface reflects; n is the index of refraction behind
/// it over the one in front.
double fresnel(double cosine, double n);

/// Share of the light from the mirror direction that is reflected to the viewer. The ratio is the
/// index of refraction in front of the surface over the one behind it.
Vec3 reflectivity(const Shading&, double ior_ratio);
