// SPDX-License-Identifier: GPL-3.0-or-later
// Frames to a film, by the program ffmpeg.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <vector>

/// The path of ffmpeg, or "" after a report. To be asked before long work.
std::string find_ffmpeg(Diagnostics&);

/// What ffmpeg is told to make the film of frames that the list names.
std::vector<std::string> movie_arguments(const std::string& list, const std::string& film);

/// The list of frames, as ffmpeg's "concat" reads it.
std::string movie_list(const std::vector<std::string>& frames, double frame_rate);

/// Makes the film. False, after a report, when ffmpeg is not there or fails; the frames stay.
bool make_movie(const std::vector<std::string>& frames, double frame_rate, const std::string& film,
                Diagnostics&);
