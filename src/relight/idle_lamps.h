// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps that could be off, each by itself, because nobody would see the difference in the picture:
// for --light-report of a picture whose light is kept by lamp.
#pragma once

#include "relight/light_records.h"

#include <string>
#include <vector>

namespace candelabra {

/// Returns for each lamp of the list whether no displayed value, from 0 to 1, of any pixel changes
/// by 1/255 if this lamp alone is off. The exposure remains that of the whole picture; grain and
/// smooth edges are left out. A lamp whose light in a tile is only known in the sum of a node
/// counts as if all of that were its own, and under a film with glare any light counts as a change,
/// so a lamp that is named is idle, while others may be. `lit`: of each lamp, whether any sample
/// has light of it; see LightRecorder::lit().
std::vector<bool> idle_lamps(const LightRecords&, const std::vector<bool>& lit, int threads);

/// Returns a line for each name with idle lamps, with their numbers, such as `Facade[3..9], [12]`.
std::string idle_lamps_report(const LampList&, const std::vector<bool>& idle);

}  // namespace candelabra
