// SPDX-License-Identifier: GPL-3.0-or-later
// The identity of a picture as a list of facts: the program, all files that were read, with their
// digests, and all options that change the picture, as their table says. States of one picture
// have the same facts, so only these are continued or merged, and differences can be named.
#pragma once

#include "options/options.h"
#include "output/layers.h"
#include "session/read_files.h"

#include <string>
#include <utility>
#include <vector>

namespace candelabra {

/// Name and value. Neither has a line break or a tab.
using Fact = std::pair<std::string, std::string>;
using Identity = std::vector<Fact>;

/// Returns the facts of a picture. Files are identified by their names without folders, so that the
/// machines of a farm may keep them in different places.
Identity identity_of(const Options&, const std::vector<ReadFile>&, const PictureFormat&);

/// Returns the combined digest of all files.
std::string scene_digest(const Identity&);

/// Returns the text about its origin that a picture file of this format holds: program, scene,
/// options, and the command that makes an equal file.
std::string description(const Identity&, int samples, const PictureFormat&);

std::string to_text(const Identity&);
Identity identity_from(const std::string& text);

/// Restores from the facts the alpha channel, the layers, the film and the names of the lights.
void tell_layers(const Identity&, FilmFiles&);
void note_film(Identity&, const FilmSettings&);
void note_lights(Identity&, std::span<const std::string> names);

/// Returns the exponent of the file's encoding that the options gave; below 0: the sRGB curve.
double file_gamma_of(const Identity&);

/// Returns the value of a fact, or empty if there is none.
std::string fact(const Identity&, const std::string& name);

/// Describes the first difference in a sentence; empty if there is none. A uniform number of
/// samples now matches a state in which it may vary.
std::string difference(const Identity& before, const Identity& now);

}  // namespace candelabra
