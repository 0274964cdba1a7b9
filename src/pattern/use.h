// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern as a statement has it: with its modifiers, its wave, and the warps and transformations
// in the order of the text. What pigments, normals and functions are made of.
#pragma once

#include "pattern/hole_rows.h"
#include "pattern/nesting.h"
#include "pattern/pattern.h"
#include "pattern/warp.h"

namespace candelabra {

struct PatternUse {
    Pattern pattern;
    PatternModifiers modifiers;
    Waveform wave;
    std::vector<WarpStep> steps;       ///< from the pattern's space outwards
    Handle<HoleRows> holes = nullptr;  ///< of these steps; null where they are few

    /// The point in the pattern's space: back through the steps, then displaced by the turbulence.
    Vec3 place(const Vec3& point) const;
    /// The value at such a place.
    double value(const Vec3& place, const PatternScene&) const;
};

/// Of the pattern without the entries of its map.
Nesting nesting(const PatternUse&);

}  // namespace candelabra
