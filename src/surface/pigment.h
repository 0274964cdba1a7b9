// SPDX-License-Identifier: GPL-3.0-or-later
// The colour of a surface: plain, or a pattern looked up in a colour map.
#pragma once

#include "base/transform.h"
#include "pattern/pattern.h"
#include "surface/colour_map.h"

#include <optional>

/// Colour as a function of a point. Default: opaque black, as in POV-Ray 3.7.
struct Pigment {
    Colour colour;  ///< where there is no pattern
    std::optional<Pattern> pattern;
    ColourMap map;        ///< never empty when there is a pattern
    Transform transform;  ///< from the pattern's space to the object's
};

/// The map that a pattern has when the text gives none.
ColourMap default_map(const Pattern&);

/// The colour at a point in the space that the pigment's transform leads to.
Colour evaluate(const Pigment&, const Vec3& point);

/// The greatest value of each channel anywhere: what a luminaire of this pigment can emit at most.
Vec3 brightest(const Pigment&);

/// Whether light can pass through it anywhere.
bool transparent(const Pigment&);
