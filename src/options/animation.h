// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of an animation with their clock values and file names, by POV-Ray's rules. Does no input
// or output.
#pragma once

#include "text/diagnostic.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Options of the command line about frames. A run is an animation if the first or the last frame
/// is given.
struct AnimationSettings {
    std::optional<double> initial_frame;  ///< unset: 1
    std::optional<double> final_frame;    ///< unset: the initial frame
    double initial_clock = 0;
    double final_clock = 1;
    /// The range of frames to render; values below 1 are fractions of all frames. The clock still
    /// runs over all frames.
    std::optional<double> subset_start_frame;
    std::optional<double> subset_end_frame;
    int frame_step = 1;
    /// The frames to render in their order, instead of a subset; empty: all.
    std::vector<int> chosen;
    /// The frame after the last would be the first, so final_clock is not reached.
    bool cyclic = false;
    bool skip_existing = false;  ///< leaves out frames whose file exists

    static const ItemInfo vocabulary;
};

/// Parses `3,7,12-20,9-5`: numbers, and ranges in either direction. Returns nothing for another
/// text, or if there are more frames than an animation has.
std::optional<std::vector<int>> frame_list(std::string_view);

struct AnimationFrame {
    int number = 0;
    double clock = 0;
};

/// The frames in order, with the values that scenes can query.
struct Animation {
    std::vector<AnimationFrame> frames;
    int initial_frame = 1;
    /// As scenes see it: one further in a cyclic animation, as in POV-Ray. Below initial_frame if
    /// the frames are numbered backwards.
    int final_frame = 1;
    double clock_delta = 0;  ///< step of the clock between frames
    int digits = 1;          ///< width of the numbers in file names
};

/// Returns the frames to render. Returns nothing if no animation is requested, or after an error
/// has been reported.
std::optional<Animation> plan(const AnimationSettings&, Diagnostics&);

/// Inserts the frame number before the extension of a path: "out.png" becomes "out07.png".
std::string numbered(const std::string& path, int frame, int digits);

}  // namespace candelabra
