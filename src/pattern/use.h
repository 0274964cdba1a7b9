// SPDX-License-Identifier: GPL-3.0-or-later
// A pattern as used in a statement: with its modifiers, its wave, and the warps and transformations
// in source order. The basis of pigments, normals and functions.
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
    Handle<HoleRows> holes = nullptr;  ///< of these steps; null if they are few

    /// Maps the point to the pattern's space: back through the steps, then displaced by the
    /// turbulence.
    Vec3 place(const Vec3& point) const;
    /// Returns the value at a point that place() returned.
    double value(const Vec3& place, const PatternScene&) const;
};

/// Of the pattern without the entries of its map.
Nesting nesting(const PatternUse&);

}  // namespace candelabra
