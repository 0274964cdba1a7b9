// SPDX-License-Identifier: GPL-3.0-or-later
// Where the light of lamps ends, as tables for --light-balance.
#pragma once

#include "render/light_balance.h"
#include "text/diagnostic.h"
#include "text/source.h"

#include <string>

namespace candelabra {

/// A balance with all that names its rows.
struct BalancedScene {
    const World& world;
    const LightBalance& balance;
    const SourceStore& sources;
    int seed = 0;
};

/// Reports that there is no light to follow, and warns of lamps that have no flux.
void review_balance(const World&, Diagnostics&);

/// Returns a row for each statement that makes lamps, and a last one for all of them: light in
/// lumens, with halves of the 95 % intervals.
std::string balance_as_csv(const BalancedScene&);
/// The same, with a row for each statement of objects that absorb light.
std::string balance_as_json(const BalancedScene&);
/// Returns the same for people: in per cent of the light of each statement.
std::string balance_as_text(const BalancedScene&);

}  // namespace candelabra
