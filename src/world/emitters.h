// SPDX-License-Identifier: GPL-3.0-or-later
// Primitives that glow become luminaires. Called when a world's primitives and materials are
// complete.
#pragma once

#include "text/diagnostic.h"
#include "world/world.h"

#include <span>

namespace candelabra {

struct GlowingPrimitive {
    PrimitiveKind kind;
    std::uint32_t index;      ///< among those of its kind
    Span span;                ///< of the object
    std::uint32_t statement;  ///< of Provenance::light_statements
};

/// Fills WorldLights::luminaires and Provenance::statement_of_luminaire. What has no area is warned
/// of. `guided`: those without a formula get their guides, which only rays need.
void add_luminaires(World&, std::span<const GlowingPrimitive>, bool guided, Diagnostics&);

/// How many primitives glow, but are no luminaires: by `no_luminaire`, by the rule which luminaires
/// there are, or because they have no end.
std::size_t glows_without_light(const World&);

}  // namespace candelabra
