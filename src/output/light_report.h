// SPDX-License-Identifier: GPL-3.0-or-later
// A table of the statements that make lights, with the contribution and the cost of each, for
// --light-report.
#pragma once

#include "text/source.h"
#include "transport/light_ledger.h"
#include "world/world.h"

#include <cstddef>
#include <string>
#include <vector>

namespace candelabra {

/// Returns the place of a statement and its beginning: "scene.pov:6: object { Lamp ...".
std::string statement_text(const Span&, const SourceStore&);

/// What the lamps of one statement contribute and cost.
struct LightRow {
    std::size_t statement = 0;  ///< in Provenance::light_statements
    double light = 0;           ///< share of all light that reached hits from lights
    double rays = 0;            ///< share of the shadow rays
    std::size_t lights = 0;     ///< their number
};

struct LightShares {
    std::vector<LightRow> rows;  ///< the brightest first
    double missed = 0;           ///< share of the shadow rays that met no light
    std::size_t glowing = 0;     ///< primitives that glow and are no luminaires
};

LightShares light_shares(const World&, const LightLedger&);

/// Returns a line for each statement that made luminaires or light sources, the brightest first:
/// its share of all light that reached hits from lights, its share of the shadow rays, its number
/// of lights, and its place. Further lines count rays that met no luminaire, and glowing primitives
/// that are no luminaires, if there are any.
std::string light_report(const World&, const LightLedger&, const SourceStore&);

}  // namespace candelabra
