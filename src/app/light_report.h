// SPDX-License-Identifier: GPL-3.0-or-later
// What light gave and cost: a table of the scene's statements that make lights. For
// --light-report.
#pragma once

#include "text/source.h"
#include "transport/light_ledger.h"
#include "world/world.h"

#include <string>

namespace candelabra {

/// The place of a statement, and how it begins: "scene.pov:6: object { Lamp ...".
std::string statement_text(const Span&, const SourceStore&);

/// A line for each statement of the scene that made luminaires or light sources, the brightest
/// first: its share of all light that came to hits from lights, its share of the shadow rays, how
/// many lights it made, and its place. Then comes a line of rays that met no luminaire, and one of
/// primitives that glow but are no luminaires, if there are some.
std::string light_report(const World&, const LightLedger&, const SourceStore&);

}  // namespace candelabra
