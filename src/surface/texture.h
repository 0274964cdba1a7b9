// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's look: pigment, normal and finish, or other textures selected by a pattern; and the
// layer below, where it shows through. Made by the evaluator, used by world and renderer.
#pragma once

#include "base/function_ref.h"
#include "base/rgb.h"
#include "surface/bump.h"
#include "surface/finish.h"
#include "surface/pigment.h"

#include <span>

namespace candelabra {

struct PatternedTexture;  // this and map entries: texture_map.h

struct Texture {
    Pigment pigment;
    Bump normal;
    Finish finish;
    Handle<PatternedTexture> choice;  ///< replaces the three above; null: none
    Handle<Texture> below;            ///< the next layer; null: this is the lowest

    /// Whether it is a single layer that looks the same wherever it is moved.
    bool plain() const { return !pigment.pattern && !normal.pattern && !choice && !below; }
};

/// Returns the texture after a transformation of its object; uv mapped parts stay.
Texture transformed(Texture, const Transform&);

/// Whether transformed() gives the same look as the texture itself, seen from the space of the
/// object that moves (`place` of for_layers()). Bumps by the u and v of an object do not.
bool moves_with_object(const Texture&);

/// Returns the texture with all its layers uv mapped.
Texture uv_mapped(Texture);

/// The same for a texture with its own uv_mapping. As in POV-Ray, its bumps turn with the object,
/// although their positions are uv coordinates.
Texture uv_mapped_with_frame(Texture);

/// Upper bound of the radiance that the surface emits.
Rgb greatest_emission(const Texture&);

/// The same without finishes that have no_luminaire, for the surface as a luminaire.
Rgb lighting_emission(const Texture&);

/// Returns the texture with ambient light of 1 or more turned into emission; the same handle if it
/// has none.
Handle<Texture> ambient_as_emission(const Handle<Texture>&, const Rgb& ambient_light);

/// Returns the texture as that of a lamp: what emits has the colour of the lamp's temperature. If
/// `all` is true, all finishes emit.
Handle<Texture> as_lamp(const Handle<Texture>&, const LampData&, bool all);

/// The lamp that a finish of the texture states, the first one of several; null: there is none.
Handle<LampData> stated_lamp(const Texture&);

/// Whether its emission varies over the surface.
bool varied(const Texture&);

/// Whether light can pass through it anywhere.
bool transparent(const Texture&);

Nesting nesting(const Texture&);

/// One layer at a point of a surface.
struct Layer {
    Colour colour;
    Vec3 normal;  ///< unit, on the side of the viewer
    const Finish* finish = nullptr;
};

/// The layers of one plain texture, top first; the weights at a point add up to 1.
using UseLayers = FunctionRef<void(double weight, std::span<const Layer>)>;

/// Calls `use` for each plain texture with a weight at a point of the surface. `normal` is a unit
/// vector on the viewer's side. `place` maps the texture's space to that of the point, the normal
/// and the layers; null: it is the same.
void for_layers(const Texture&, const Vec3& point, const Vec3& normal, const PatternScene&,
                UseLayers use, const Transform* place = nullptr);

/// Fraction of light that passes through all layers at a point, per channel.
Rgb passing(const Texture&, const Vec3& point, const PatternScene&);

/// Light through a surface that focuses it at normal incidence.
struct FocusedLight {
    Vec3 direction;
    Vec3 normal;   ///< of the surface; unit, opposite to the direction's side
    double power;  ///< exponent of the focus, not 0
};

/// The same with bright spots in the shadow, by the angle to the normal of each layer.
Rgb passing(const Texture&, const Vec3& point, const PatternScene&, const FocusedLight&,
            const Transform* place = nullptr);

/// Whether less than passing() is seen behind it, as one of its finishes reflects the rest or has
/// `refraction`.
bool takes_from_behind(const Texture&);

/// Whether one of its finishes is a microfacet material.
bool scatters(const Texture&);

/// Whether one of its finishes sends light to other surfaces other than by diffuse reflection or as
/// a luminaire: by highlights, mirrors, an ambient part, or emission that is no luminaire.
bool has_other_light(const Texture&);

/// Whether one of its finishes has a second diffuse value.
bool shows_light_from_behind(const Texture&);

/// Whether one of its finishes has subsurface scattering, if the scene enables it.
bool lets_light_in(const Texture&);

/// Whether one of its finishes has a reflection exponent.
bool reflects_to_a_power(const Texture&);

/// Radiance that all layers emit at a point. `opacity` returns the opaque fraction of a layer's
/// colour, which depends on the language version.
Rgb emission(const Texture&, const Vec3& point, const PatternScene&,
             FunctionRef<double(const Colour&)> opacity);

}  // namespace candelabra
