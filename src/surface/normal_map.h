// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a perturbed normal, for code that makes, evaluates or writes one.
#pragma once

#include "pattern/use.h"
#include "surface/bump.h"

namespace candelabra {

/// Height and slope at a value of the pattern.
struct SlopeStop {
    double value = 0;
    double height = 0;
    double slope = 0;
};

/// One entry of a normal_map. For `average` the value is a weight.
struct NormalStop {
    double value = 0;
    Bump bump;
};

/// How strongly the pattern acts.
struct BumpSettings {
    double bump_size = 0.5;
    double accuracy = 0.02;
    bool no_bump_scale = false;

    static const ItemInfo vocabulary;
};

/// A pattern with its effect on normals.
struct PatternedBump {
    using Map = std::variant<std::monostate, SlopeMap, NormalMap>;
    /// Precondition: no map is empty; weights of an average are not negative and not all 0.
    PatternedBump(PatternUse, const BumpSettings&, Map);

    PatternUse use;
    BumpSettings settings;
    Map map;
    Nesting nesting;
};

/// The height at a value, by cubic interpolation between the stops.
double look_up(const SlopeMap&, double value);

}  // namespace candelabra
