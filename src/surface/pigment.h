// SPDX-License-Identifier: GPL-3.0-or-later
// The colour of a surface: plain, or a pattern that selects colours or other pigments.
#pragma once

#include "base/handle.h"
#include "base/rgb.h"
#include "base/transform.h"
#include "pattern/modifiers.h"
#include "pattern/nesting.h"
#include "surface/colour_map.h"

namespace candelabra {

struct PatternedPigment;  // this and map entries: pigment_map.h
struct PigmentStop;
using PigmentMap = std::vector<PigmentStop>;
struct PigmentGrey;  // pattern/scene_patterns.h

/// Colour as a function of a point. Default: opaque black, as in POV-Ray 3.7.
struct Pigment {
    Colour colour;                     ///< where there is no pattern
    Handle<PatternedPigment> pattern;  ///< null: one colour everywhere
    Transform transform;               ///< after all steps of the pattern: to the object's space
    bool uv = false;                   ///< the object's space is (u, v, 0), and does not move with
                                       ///< it
    Handle<Colour> quick = {};         ///< replaces all of these at low quality; null: none
};

Nesting nesting(const Pigment&);

/// The colour at a point in the space to which the pigment's transform leads.
Colour evaluate(const Pigment&, const Vec3& point, const PatternScene& = {});

/// The point (u, v, 0) of a surface.
inline Vec3 uv_place(const PatternScene& scene) { return {scene.uv.x, scene.uv.y, 0}; }

/// Upper bound of each channel everywhere, for the emission of a luminaire of this pigment.
Rgb brightest(const Pigment&);

/// Whether light can pass through it anywhere.
bool transparent(const Pigment&);

/// The brightness of the pigment as a function of the point, for pigment_pattern.
PigmentGrey grey_of(Pigment);

}  // namespace candelabra
