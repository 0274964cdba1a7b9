// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a pigment with a pattern, for code that makes, evaluates or writes one.
#pragma once

#include "base/rgb.h"
#include "pattern/use.h"
#include "surface/pigment.h"

namespace candelabra {

/// One entry of a pigment map. For `average` the value is a weight.
struct PigmentStop {
    double value = 0;
    Pigment pigment;
};

/// A pattern with the colours or pigments that it selects.
struct PatternedPigment {
    using Map = std::variant<ColourMap, PigmentMap>;
    /// Precondition: the map is not empty; weights of an average are not negative and not all 0.
    PatternedPigment(PatternUse, Map);

    PatternUse use;
    Map map;
    Nesting nesting;
    Rgb brightest;       ///< see brightest() in pigment.h
    bool clear = false;  ///< light can pass through it somewhere
};

}  // namespace candelabra
