// SPDX-License-Identifier: GPL-3.0-or-later
// How the progress of a run is reported: by --progress.
#pragma once

#include <optional>
#include <string_view>

namespace candelabra {

/// The last three are for programs: a JSON object per line, and the formats of RenderMan's queues
/// and of Open Job Description.
enum class ProgressStyle { silent, lines, terminal, json, alf, openjd };

/// The part of a whole job that some work is. Only programs are told.
struct ProgressShare {
    double first = 0, last = 1;
};

/// Returns the style with this name for `--progress`, or nothing for another word.
std::optional<ProgressStyle> progress_style(std::string_view name);

}  // namespace candelabra
