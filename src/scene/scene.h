// SPDX-License-Identifier: GPL-3.0-or-later
// The description of a scene: plain values, each with the place that made it. What the evaluator
// returns and the world is compiled from. It holds no acceleration structure and shoots no ray.
#pragma once

#include "backdrop/background.h"
#include "backdrop/rainbow.h"
#include "backdrop/sky_sphere.h"
#include "base/handle.h"
#include "base/transform.h"
#include "camera/camera.h"
#include "camera/film_settings.h"
#include "light/light.h"
#include "medium/fog.h"
#include "medium/interior.h"
#include "medium/media.h"
#include "method/photons.h"
#include "scene/settings.h"
#include "shape/shape.h"
#include "surface/texture.h"
#include "text/span.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <variant>
#include <vector>

namespace candelabra {

struct Object;
/// Objects are shared, never changed once they are made: a lamp that stands a million times is
/// stored once.
using ObjectHandle = Handle<Object>;

/// A light source of POV-Ray's kind.
struct PlacedLight {
    Light light;
    Span span;
    ObjectHandle looks_like = {};  ///< stands at the light, casts no shadow; null: none
    /// It lights what is seen through this, which is not there otherwise; null: all.
    ObjectHandle projected_through = {};
    LightPhotons photons = {};
};

/// How several objects make one.
enum class Csg : std::uint8_t {
    together,      ///< a union: all of them
    intersection,  ///< what is inside of all
    difference,    ///< the first without the others
    merge,         ///< a union without the surfaces that are inside of others
};

/// Several objects as one.
struct Union {
    std::vector<ObjectHandle> children;
    std::vector<PlacedLight> lights;  ///< all light sources in it and in unions in it, in its own
                                      ///< space; Scene::lights has them too
    std::vector<PlacedLight> free_lights;  ///< of a light group: those in unions in it
    Csg csg = Csg::together;
    bool light_group = false;    ///< its own lights light nothing else; Scene::lights lacks them
    bool global_lights = false;  ///< of a light group: other lights light it as well
    bool lamp = false;           ///< stands for a light source, with what it looks like
    bool named = false;          ///< made of a declared one, which a group around lights, too
};

/// Spheres that are alike in all but place and size, as one object of a scene or a union: loops
/// make them by the million. Never empty.
struct SphereRow {
    std::vector<Sphere> spheres;
    std::vector<Span> spans;  ///< of each
};

/// What cuts an object without closing it, and what rays must meet to see it. In the space after
/// the object's transform.
struct Clipping {
    std::vector<ObjectHandle> clips;
    std::vector<ObjectHandle> bounds;
};

/// Textures of parts of a shape, which know them by their place in the list, and of its inner side.
struct PartTextures {
    std::vector<Handle<Texture>> list;
    Handle<Texture> interior;  ///< of the side that is seen from inside; null: as outside
};

/// What can be switched on an object.
struct Switches {
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool no_radiosity = false;
    bool no_luminaire = false;
    bool hollow = false;
    bool inverse = false;
    bool double_illuminate = false;
    bool uv_mapping = false;                  ///< textures are on u and v
    Handle<ObjectPhotons> photons = nullptr;  ///< null: the parent's, or nothing is said

    static const ItemInfo vocabulary;
    friend bool operator==(const Switches&, const Switches&) = default;
};

/// One object: a shape, a union or a row, where it stands and how it looks.
struct Object : Switches {
    std::variant<Shape, Union, SphereRow> form;
    Handle<Transform> transform;  ///< of the form; null: none
    /// In the space after the transform; null: the parent's, or the default.
    Handle<Texture> texture;
    Handle<Interior> interior;           ///< null: the parent's, or the atmosphere
    Handle<Clipping> clipping;           ///< null: none
    Handle<PartTextures> part_textures;  ///< in the same space as the texture; null: none
    Span span;
    std::uint32_t depth = 0;  ///< how many objects lie inside each other in it: it can be recursed
                              ///< through so deeply
    std::uint32_t parts = 1;  ///< how many it consists of, itself included; the greatest number
                              ///< stands for all that are greater

    const Switches& switches() const { return *this; }
    Switches& switches() { return *this; }
};

/// Notes that an object becomes part of another.
inline void nest(Object& outer, const Object& inner) {
    outer.depth = std::max(outer.depth, inner.depth + 1);
    outer.parts += std::min(inner.parts, std::numeric_limits<std::uint32_t>::max() - outer.parts);
}

/// An object after one more transformation, with its textures and what clips it.
ObjectHandle transformed(ObjectHandle, const Transform&);
/// A light source after one more transformation, with all that belongs to it.
PlacedLight transformed(PlacedLight, const Transform&);

struct Scene {
    std::vector<ObjectHandle> objects;
    std::vector<PlacedLight> lights;
    Camera camera;
    Bump camera_normal;         ///< disturbs the directions of its rays
    FilmSettings film;          ///< of the camera
    bool camera_given = false;  ///< otherwise it is the default
    Background background;
    std::optional<SkySphere> sky;
    std::vector<Fog> fogs;
    std::vector<Media> media;  ///< fill all that is outside of solids
    std::vector<Rainbow> rainbows;
    GlobalSettings settings;
    double language_version = 3.7;  ///< the last version in force; 3.62 when the scene names none
    bool gamma_handling = true;     ///< false: colours are written as they are (before version 3.7,
                                    ///< without assumed_gamma)
};

}  // namespace candelabra
