// SPDX-License-Identifier: GPL-3.0-or-later
// All patterns. A pattern is a function from a point to a number, mostly in 0..1, or to a small
// integer that picks from a list. The type list is the registry. Each kind declares the properties
// in which it differs from the others (a default wave, a list, no displacement).
#pragma once

#include "pattern/bands.h"
#include "pattern/cellular.h"
#include "pattern/density_file.h"
#include "pattern/falloff.h"
#include "pattern/fractal.h"
#include "pattern/function_pattern.h"
#include "pattern/noise_patterns.h"
#include "pattern/pavement.h"
#include "pattern/picture_map.h"
#include "pattern/quilted.h"
#include "pattern/ripples.h"
#include "pattern/scene_patterns.h"
#include "pattern/slope.h"
#include "pattern/tiles.h"
#include "pattern/tiling.h"
#include "pattern/waveform.h"

namespace candelabra {

using Pattern =
    std::variant<Agate, Aoi, Average, Boxed, Bozo, Brick, BumpMap, Bumps, Cells, Checker, Crackle,
                 CubicPattern, CylindricalPattern, Dents, DensityFile, Facets, FunctionPattern,
                 Gradient, Granite, Hexagon, ImageMap, ImagePattern, JuliaPattern, Leopard, Magnet,
                 Mandel, Marble, MaterialMap, ObjectPattern, Onion, Pavement, PigmentGrey,
                 PlanarPattern, Quilted, Radial, Ripples, Slope, SphericalPattern, Spiral1, Spiral2,
                 Spotted, Square, Tiling, Triangular, Waves, Wood, Wrinkles>;

/// Returns the value before any wave is applied.
double evaluate(const Pattern&, const PatternPoint&);

/// Returns the number of colours or pigments that may follow the name as a list; 0: it takes a map.
int choices(const Pattern&);

/// Returns the only block that the pattern may occur in: "pigment", "normal" or "texture"; empty:
/// any.
std::string_view home(const Pattern&);

/// Returns the pattern's picture; null if it has none.
const PictureMap* picture_of(const Pattern&);
PictureMap* picture_of(Pattern&);

/// Whether turbulence displaces the point; otherwise the pattern uses it in another way.
bool displaced(const Pattern&);

/// Applies the settings that naming the pattern implies to its statement. Other settings keep their
/// values, as in POV-Ray 3.7.
void name_pattern(const Pattern&, PatternModifiers&, Waveform&);

}  // namespace candelabra
