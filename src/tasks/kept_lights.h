// SPDX-License-Identifier: GPL-3.0-or-later
// The light of each lamp that a run keeps for `candelabra relight`, by --keep-lights.
#pragma once

#include "options/options.h"
#include "text/diagnostic.h"

#include <memory>

namespace candelabra {

class Film;
struct FilmFiles;
class LightRecorder;
struct PictureFormat;
class SourceStore;
class World;

/// Reports options that do not go together with --keep-lights.
void check_kept_lights(const Options&, Diagnostics&);

/// Returns what keeps the light while a picture of this format is made. Returns null if that is not
/// wanted, or after an error has been reported.
std::unique_ptr<LightRecorder> light_recorder(const World&, const SourceStore&,
                                              const PictureFormat&, const Options&, Diagnostics&);

/// Writes the light of a film that is complete. Reports failure.
void write_kept_lights(LightRecorder&, const Film&, const FilmFiles&, const Options&, Diagnostics&);

}  // namespace candelabra
