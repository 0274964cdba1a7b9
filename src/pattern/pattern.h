// SPDX-License-Identifier: GPL-3.0-or-later
// Every pattern there is: a function from a point to a number, mostly in 0..1, or to a small whole
// number that picks from a list. The type list is the registry; what makes a kind differ from the
// others (a wave of its own, a list, no displacement) is stated in the kind.
#pragma once

#include "pattern/bands.h"
#include "pattern/cellular.h"
#include "pattern/density_file.h"
#include "pattern/falloff.h"
#include "pattern/fractal.h"
#include "pattern/function_pattern.h"
#include "pattern/noise_patterns.h"
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
                 Mandel, Marble, MaterialMap, ObjectPattern, Onion, PigmentGrey, PlanarPattern,
                 Quilted, Radial, Ripples, Slope, SphericalPattern, Spiral1, Spiral2, Spotted,
                 Square, Tiling, Triangular, Waves, Wood, Wrinkles>;

/// The value before any wave.
double evaluate(const Pattern&, const PatternPoint&);

/// How many colours or pigments may follow the name as a list; 0: it takes a map.
int choices(const Pattern&);

/// The one block that the pattern may stand in: "pigment", "normal" or "texture"; empty: any.
std::string_view home(const Pattern&);

/// What a pattern has of a picture; null when it is made of none.
const PictureMap* picture_of(const Pattern&);
PictureMap* picture_of(Pattern&);

/// Whether turbulence displaces the point; otherwise the pattern does something else with it.
bool displaced(const Pattern&);

/// What naming the pattern sets in its statement. What it does not set stays as it was, as in
/// POV-Ray 3.7.
void name_pattern(const Pattern&, PatternModifiers&, Waveform&);

}  // namespace candelabra
