// SPDX-License-Identifier: GPL-3.0-or-later
// Turns glowing primitives into luminaires. Called when a world's primitives and materials are
// complete.
#pragma once

#include "shape/watertight.h"
#include "text/diagnostic.h"
#include "world/world.h"

#include <span>

namespace candelabra {

struct GlowingPrimitive {
    PrimitiveKind kind;
    std::uint32_t index;      ///< among the primitives of its kind
    Span span;                ///< of the object
    std::uint32_t statement;  ///< in Provenance::light_statements
    Closure closure = Closure::none;  ///< of the mesh whose face it is
};

/// Fills WorldLights::luminaires and Provenance::statement_of_luminaire, and warns of luminaires
/// without area. `with_proxy`: luminaires without a formula get proxy meshes, which only rendering
/// needs.
void add_luminaires(World&, std::span<const GlowingPrimitive>, bool with_proxy, Diagnostics&);

/// The same for a prototype, whose luminaires it fills; the world does not change. Returns false if
/// some of them could not be placed.
bool add_luminaires(World&, Prototype&, std::span<const GlowingPrimitive>, bool guided,
                    Diagnostics&);

/// Adds the luminaires of all instances behind the others. `statements`: of each instance.
void place_luminaires(World&, std::span<const std::uint32_t> statements);

/// Whether any surface or medium shows light that arrives from luminaires. Otherwise there is no
/// use for luminaires.
bool receives_light(const World&);

/// Number of primitives that glow but are not luminaires: because of `no_luminaire`, by the scene's
/// rule for luminaires, or because they are infinite.
std::size_t glows_without_light(const World&);

}  // namespace candelabra
