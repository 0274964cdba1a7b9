// SPDX-License-Identifier: GPL-3.0-or-later
// What a picture is of, as facts: the program, all files that were read, with their digests, and
// all options that change the picture. States of the same picture have the same facts; so a state
// is continued or merged only with its own kind, and what differs has a name.
#pragma once

#include "app/options.h"
#include "session/read_files.h"

#include <string>
#include <utility>
#include <vector>

namespace candelabra {

/// Name and value. Neither has a line break or a tabulator.
using Fact = std::pair<std::string, std::string>;
using Identity = std::vector<Fact>;

/// The facts of a picture. Files go by their names without folders, so that the machines of a farm
/// may keep them at different places.
Identity identity_of(const Options&, const std::vector<ReadFile>&, const PictureFormat&);

/// The digest of all files together.
std::string scene_digest(const Identity&);

/// What a picture file says about its origin: program, scene, options, and the command that makes
/// it again.
std::string description(const Identity&, int samples);

std::string to_text(const Identity&);
Identity identity_from(const std::string& text);

/// Whether the picture has an alpha channel, which layers, its film, and the names of its lights.
void tell_layers(const Identity&, FilmFiles&);
void note_film(Identity&, const FilmSettings&);
void note_lights(Identity&, std::span<const std::string> names);

/// The value of a fact; empty when there is none.
std::string fact(const Identity&, const std::string& name);

/// What differs, as a sentence; empty when the facts are the same. That all pixels shall have the
/// same number of samples now is no difference to a state where they need not.
std::string difference(const Identity& before, const Identity& now);

}  // namespace candelabra
