// SPDX-License-Identifier: GPL-3.0-or-later
// The description of a scene: plain values with their places in the source. The evaluator returns
// it, and the world is compiled from it. It holds no acceleration structure and traces no rays.
#pragma once

#include "backdrop/background.h"
#include "backdrop/daylight.h"
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
#include "meter/meter.h"
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
/// Objects are shared and never changed once they are made: a lamp that occurs a million times is
/// stored once.
using ObjectHandle = Handle<Object>;

/// A light source as in POV-Ray.
struct PlacedLight {
    PointLight light;
    Span span;
    ObjectHandle looks_like = {};  ///< placed at the light, casts no shadow; null: none
    /// The light reaches only points seen through this object, which is not drawn; null: all
    /// points.
    ObjectHandle projected_through = {};
    LightPhotons photons = {};
    Handle<std::string> light_name = {};  ///< see Union
};

/// How several objects are combined.
enum class Csg : std::uint8_t {
    together,      ///< a union: all of them
    intersection,  ///< the region inside of all
    difference,    ///< the first without the others
    merge,         ///< a union without the surfaces that are inside of others
};

struct Union {
    std::vector<ObjectHandle> children;
    /// All light sources in it and in nested unions, in its own space; Scene::lights has them, too.
    std::vector<PlacedLight> lights;
    std::vector<PlacedLight> free_lights;  ///< of a light group: those in nested unions
    Csg csg = Csg::together;
    bool light_group = false;    ///< its lights light only its objects; not in Scene::lights
    bool global_lights = false;  ///< of a light group: other lights light it as well
    bool lamp = false;           ///< stands for a light source and its looks_like
    bool named = false;          ///< of a declared object: an outer light group lights it, too
    /// The name of all its light in layers, which is that of unions with the same name, too; null:
    /// the light is named by its statement.
    Handle<std::string> light_name = {};
};

/// Spheres that differ only in place and size, as one object of a scene or a union: loops make them
/// by the million. Never empty.
struct SphereRow {
    std::vector<Sphere> spheres;
    std::vector<Span> spans;  ///< one for each sphere
};

/// Objects that cut an object without closing it, and objects that rays must hit to see it. In the
/// space after the object's transform.
struct Clipping {
    std::vector<ObjectHandle> clips;
    std::vector<ObjectHandle> bounds;
};

/// Textures of the parts of a shape, which refer to them by index, and of its inner side.
struct PartTextures {
    std::vector<Handle<Texture>> list;
    Handle<Texture> interior;  ///< of the inner side; null: as outside
};

/// Modifiers that are switched on or off.
struct Switches {
    bool no_shadow = false;
    bool no_image = false;
    bool no_reflection = false;
    bool no_radiosity = false;
    bool no_luminaire = false;
    bool hollow = false;
    bool inverse = false;
    bool double_illuminate = false;
    bool uv_mapping = false;                  ///< textures are evaluated at u and v
    Handle<ObjectPhotons> photons = nullptr;  ///< null: those of the parent, or unspecified
    /// States the flux of all that glows in it together; null: nothing is stated.
    Handle<LampData> lamp = nullptr;

    static const ItemInfo vocabulary;
    friend bool operator==(const Switches&, const Switches&) = default;
};

/// A shape, a union or a row with its transform and appearance.
struct Object : Switches {
    std::variant<Shape, Union, SphereRow> form;
    Handle<Transform> transform;  ///< of the form; null: none
    /// In the space after the transform; null: the parent's, or the default.
    Handle<Texture> texture;
    Handle<Interior> interior;           ///< null: the parent's, or the atmosphere
    Handle<Clipping> clipping;           ///< null: none
    Handle<PartTextures> part_textures;  ///< in the same space as the texture; null: none
    Span span;
    /// Depth of the nesting of objects in it, which bounds a recursion through it.
    std::uint32_t depth = 0;
    /// Number of objects that it consists of, including itself; saturates at the maximum.
    std::uint32_t parts = 1;

    const Switches& switches() const { return *this; }
    Switches& switches() { return *this; }
};

/// Updates depth and parts of an object to which another one is added.
inline void nest(Object& outer, const Object& inner) {
    outer.depth = std::max(outer.depth, inner.depth + 1);
    outer.parts += std::min(inner.parts, std::numeric_limits<std::uint32_t>::max() - outer.parts);
}

/// The object after one more transformation, with its textures and its clipping.
ObjectHandle transformed(ObjectHandle, const Transform&);
/// The light source after one more transformation, with its objects.
PlacedLight transformed(PlacedLight, const Transform&);

struct Scene {
    std::vector<ObjectHandle> objects;
    std::vector<PlacedLight> lights;
    Camera camera;
    Bump camera_normal;         ///< perturbs the directions of camera rays
    FilmSettings film;          ///< of the camera
    Handle<Pigment> bokeh;      ///< the opening of its lens as a picture; null: none
    bool camera_given = false;  ///< false: the camera is the default
    Background background;
    std::optional<SkySphere> sky;
    Span sky_statement;                ///< of `sky`
    std::optional<Daylight> daylight;  ///< behind `sky`
    Span daylight_statement;           ///< of `daylight`
    std::vector<Fog> fogs;
    std::vector<Media> media;  ///< fill all space outside of solids
    std::vector<Rainbow> rainbows;
    std::vector<Meter> meters;
    GlobalSettings settings;
    double language_version = 3.7;  ///< the last version in force; 3.62 if the scene gives none
    /// False: colours are written unchanged (before version 3.7, without assumed_gamma).
    bool gamma_handling = true;
};

}  // namespace candelabra
