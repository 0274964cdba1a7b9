// SPDX-License-Identifier: GPL-3.0-or-later
// Joins frames to a movie with the program ffmpeg.
#pragma once

#include "text/diagnostic.h"

#include <string>
#include <vector>

namespace candelabra {

/// Whether ffmpeg is installed and supports this file name, tested with a black picture. Returns
/// false after an error has been reported. Call it before long work.
bool can_make_movie(double frame_rate, const std::string& film, Diagnostics&);

/// Returns the arguments with which ffmpeg makes the film from the frames in the list.
std::vector<std::string> movie_arguments(const std::string& list, const std::string& film);

/// Returns the list of frames for ffmpeg's "concat" demuxer.
std::string movie_list(const std::vector<std::string>& frames, double frame_rate);

/// Returns the path of a temporary picture from which a film or a contact sheet is made: a hidden
/// file beside it. `ending`: with its dot.
std::string hidden_part(const std::string& whole, std::size_t number, std::string_view ending);

/// Makes the film and replaces an older one atomically. Returns false, after an error has been
/// reported, if ffmpeg is missing or fails; the frames stay. There must be at least one frame. No
/// frame may be an OpenEXR file, whose long text attributes ffmpeg 5 cannot read.
bool make_movie(const std::vector<std::string>& frames, double frame_rate, const std::string& film,
                Diagnostics&);

}  // namespace candelabra
