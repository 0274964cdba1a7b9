// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's look: pigment, normal and finish, or others that a pattern chooses from; and what
// lies below, where it can be seen through. Made by the evaluator, asked by world and renderer.
#pragma once

#include "base/function_ref.h"
#include "surface/bump.h"
#include "surface/finish.h"
#include "surface/pigment.h"

#include <span>

namespace candelabra {

struct PatternedTexture;  // this and the entries of maps: texture_map.h

struct Texture {
    Pigment pigment;
    Bump normal;
    Finish finish;
    Handle<PatternedTexture> choice;  ///< instead of the three above; null: none
    Handle<Texture> below;            ///< the next layer; null: this is the lowest

    /// Looks the same wherever it is moved to, and is all there is.
    bool plain() const { return !pigment.pattern && !normal.pattern && !choice && !below; }
};

/// The texture after a transformation of the object that carries it; what is on u and v stays.
Texture transformed(Texture, const Transform&);

/// The texture with all its layers on u and v.
Texture uv_mapped(Texture);

/// The same for a texture that asks for it itself. As in POV-Ray, its bumps turn with the object,
/// although their places stay on u and v.
Texture uv_mapped_with_frame(Texture);

/// Radiance that the surface emits at most.
Vec3 greatest_emission(const Texture&);

/// The same of what makes a luminaire of it: without finishes that say no_luminaire.
Vec3 lighting_emission(const Texture&);

/// The texture with all ambient light of 1 or more as emission; the same one when it has none.
Handle<Texture> ambient_as_emission(const Handle<Texture>&, const Vec3& ambient_light);

/// Whether its emission differs from place to place.
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

/// The layers of one plain texture, the top one first; the weights of all at a point add up to 1.
using UseLayers = FunctionRef<void(double weight, std::span<const Layer>)>;

/// Calls `use` for each plain texture that counts at a point of the surface. `normal` is unit and
/// on the side of the viewer.
void for_layers(const Texture&, const Vec3& point, const Vec3& normal, const PatternScene&,
                UseLayers use);

/// The share of light that passes through all layers at a point, per channel.
Vec3 passing(const Texture&, const Vec3& point, const PatternScene&);

/// Light on its way through a surface that focuses it where it comes straight on.
struct FocusedLight {
    Vec3 direction;
    Vec3 normal;   ///< of the surface; unit, on the side that the direction points away from
    double power;  ///< not 0
};

/// The same with bright spots in the shadow, by the angle to each layer's own normal.
Vec3 passing(const Texture&, const Vec3& point, const PatternScene&, const FocusedLight&);

/// Whether one of its finishes has facets.
bool scatters(const Texture&);

/// Whether one of its finishes sends light to other surfaces that is no diffuse reflection: it has
/// highlights, mirrors, or an ambient part.
bool has_other_light(const Texture&);

/// Whether one of its finishes has light spread below the surface, if the scene wants that.
bool lets_light_in(const Texture&);

/// Whether one of its finishes raises what it reflects to a power.
bool reflects_to_a_power(const Texture&);

/// The radiance that all layers emit at a point. `opacity` is the share of a layer's colour that is
/// its own, which depends on the version of the language.
Vec3 emission(const Texture&, const Vec3& point, const PatternScene&,
              FunctionRef<double(const Colour&)> opacity);

}  // namespace candelabra
