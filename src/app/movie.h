// SPDX-License-Identifier: GPL-3.0-or-later
// Frames to a film, by the program ffmpeg.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <vector>

namespace candelabra {

/// Whether ffmpeg is there and makes films of this name: it makes one of a black picture. False
/// after a report. To be asked before long work.
bool can_make_movie(double frame_rate, const std::string& film, Diagnostics&);

/// What ffmpeg is told to make the film of frames that the list names.
std::vector<std::string> movie_arguments(const std::string& list, const std::string& film);

/// The list of frames, as ffmpeg's "concat" reads it.
std::string movie_list(const std::vector<std::string>& frames, double frame_rate);

/// A picture for the film of a frame that has light, while the film is made: hidden beside it.
std::string developed_frame(const std::string& film, std::size_t number);

/// Makes the film; a reader sees the whole of it or the one before. False, after a report, when
/// ffmpeg is not there or fails; the frames stay. At least one frame; none is an OpenEXR file,
/// whose texts ffmpeg 5 does not read when they are long.
bool make_movie(const std::vector<std::string>& frames, double frame_rate, const std::string& film,
                Diagnostics&);

}  // namespace candelabra
