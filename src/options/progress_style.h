// SPDX-License-Identifier: GPL-3.0-or-later
// How the progress of a run is reported: by --progress.
#pragma once

#include <optional>
#include <string_view>

namespace candelabra {

/// The last four are for programs: a JSON object per line, the formats of RenderMan's queues and of
/// Open Job Description, and the lines of POV-Ray, which speak of one picture and its pixels.
enum class ProgressStyle { silent, lines, terminal, json, alf, openjd, povray };

/// The part of a whole job that some work is. Only programs are told.
struct ProgressShare {
    double first = 0, last = 1;
};

/// Returns the style with this name for `--progress`, or nothing for another word.
std::optional<ProgressStyle> progress_style(std::string_view name);

}  // namespace candelabra
