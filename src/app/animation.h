// SPDX-License-Identifier: GPL-3.0-or-later
// Which frames an animation has, with their clocks and file names: POV-Ray's rules. Reads and
// writes nothing.
#pragma once

#include "text/diagnostic.h"
#include "vocabulary/item_info.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

/// What the command line says about frames. There is an animation when the first or the last frame
/// is given.
struct AnimationSettings {
    std::optional<double> initial_frame;  ///< nothing: 1
    std::optional<double> final_frame;    ///< nothing: the initial one
    double initial_clock = 0;
    double final_clock = 1;
    /// Frames that are rendered; below 1 a fraction of all. The clock goes by all frames.
    std::optional<double> subset_start_frame;
    std::optional<double> subset_end_frame;
    int frame_step = 1;
    bool cyclic = false;         ///< the last frame comes before the first: clock 1 is not reached
    bool skip_existing = false;  ///< leaves frames out whose file is there

    static const ItemInfo vocabulary;
};

struct AnimationFrame {
    int number = 0;
    double clock = 0;
};

/// The frames in order, and what scenes are told about them.
struct Animation {
    std::vector<AnimationFrame> frames;
    int initial_frame = 1;
    int final_frame = 1;     ///< as scenes see it: one more in a cyclic animation, as in POV-Ray
    double clock_delta = 0;  ///< of the clock from one frame to the next
    int digits = 1;          ///< of the numbers in file names
};

/// Nothing when no frames are asked for, or after a report.
std::optional<Animation> plan(const AnimationSettings&, Diagnostics&);

/// The name with the frame's number before its ending: "out.png" to "out07.png".
std::string numbered(const std::string& path, int frame, int digits);

}  // namespace candelabra
