// SPDX-License-Identifier: GPL-3.0-or-later
// The light of each lamp that a run keeps for `candelabra relight`, by --keep-lights.
#pragma once

#include "options/options.h"
#include "text/diagnostic.h"

#include <memory>
#include <span>
#include <string>

namespace candelabra {

class Film;
struct FilmFiles;
struct LightRecords;
class LightRecorder;
struct Meter;
struct PictureFormat;
class SceneSteps;
struct Shot;
class SourceStore;

/// Reports options that do not go together with --keep-lights.
void check_kept_lights(const Options&, Diagnostics&);

/// Returns what keeps the light while a picture of this format is made. Returns null if that is not
/// wanted, or after an error has been reported.
std::unique_ptr<LightRecorder> light_recorder(const Shot&, const SourceStore&, const PictureFormat&,
                                              const Options&, Diagnostics&);

/// Measures the light of each lamp at the meters whose readings are sums, as --measure would with
/// these options, and has it kept with that of the picture. Returns false if a signal came.
bool keep_meters(LightRecorder&, SceneSteps&, const Shot&, std::span<const Meter>);

/// Writes the light of a film that is complete, and returns it. Reports failure.
LightRecords write_kept_lights(const LightRecorder&, const Film&, const FilmFiles&,
                               const std::string& path, Diagnostics&);

}  // namespace candelabra
