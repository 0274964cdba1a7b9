// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/modifiers.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo PatternModifiers::vocabulary = described<PatternModifiers>([] {
    using F = Field<PatternModifiers>;
    return schema<PatternModifiers>(
        "pattern",
        {"What may follow a pattern's name and values.",
         "pigment { granite turbulence 0.5 scale 0.5 }",
         "pigment { gradient x turbulence 0.4 octaves 3 omega 0.6 lambda 2.5 scale 0.4 }",
         "pigment { bozo noise_generator 1 scale 0.2 }",
         "pigment { radial frequency 6 phase 0.25 rotate 90*x }"},
        F{"turbulence", &PatternModifiers::turbulence, item,
          "how far noise displaces the point along each axis, or what the pattern states"},
        F{"octaves", &PatternModifiers::octaves, item,
          "terms of the turbulence; below 1 counts as 1, above 10 as 10"},
        F{"omega", &PatternModifiers::omega, item, "size of each octave over the one before"},
        F{"lambda", &PatternModifiers::lambda, item,
          "frequency of each octave over the one before"},
        F{"noise_generator", &PatternModifiers::noise_generator, item,
          "1 and 2 differ in range, 3 is Perlin's noise, 0 that of global_settings", between(0, 3)},
        F{"frequency", &PatternModifiers::frequency, item,
          "repeats of the map while the pattern's value grows by 1"},
        F{"phase", &PatternModifiers::phase, item, "part of the map by which each repeat shifts"});
});

}  // namespace candelabra
