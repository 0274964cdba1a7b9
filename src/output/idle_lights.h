// SPDX-License-Identifier: GPL-3.0-or-later
// Lamps that could be off, because nobody would see the difference in the picture: for
// --light-report of a picture that has a layer of light for each statement.
#pragma once

#include "text/source.h"

#include <string>
#include <vector>

namespace candelabra {

class Film;
struct FilmFiles;
class World;

/// The greatest change of a displayed value, from 0 to 1, of any pixel if the light of a statement
/// were off, for each of Provenance::light_statements. The exposure remains that of the whole
/// picture; grain and smooth edges are left out. The film must have layers of light.
std::vector<double> changes_without(const Film&, const FilmFiles&);

/// Returns a line for each statement whose light changes no pixel by as much as one step of 255.
std::string idle_lights_report(const World&, const std::vector<double>& changes,
                               const SourceStore&);

}  // namespace candelabra
