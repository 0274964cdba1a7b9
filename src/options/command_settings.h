// SPDX-License-Identifier: GPL-3.0-or-later
// The shell commands that the user has run before and after pictures, as POV-Ray's INI files name
// them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace candelabra {

/// The time at which a command is run.
enum class Moment { pre_scene, pre_frame, post_frame, post_scene, user_abort, fatal_error };
inline constexpr std::size_t moment_count = 6;

/// Action after a command that failed (or succeeded, if inverted), by POV-Ray's letters.
enum class After : char {
    ignore = 'I',
    skip = 'S',  ///< this picture, or all pictures outside of a frame
    all = 'A',   ///< also skips the remaining pictures
    quit = 'Q',  ///< ends the run as if it were complete
    abort = 'U',
    fatal = 'F',
};

struct CommandSettings {
    struct One {
        std::string command;  ///< empty: none
        std::string given;    ///< the option with its place, for messages
        After after = After::ignore;
        bool inverted = false;  ///< the action follows a success
    };
    std::array<One, moment_count> all;
    bool allowed = false;

    const One& operator[](Moment moment) const { return all[static_cast<std::size_t>(moment)]; }
    One& operator[](Moment moment) { return all[static_cast<std::size_t>(moment)]; }
    bool any() const {
        return std::ranges::any_of(all, [](const One& one) { return !one.command.empty(); });
    }
};

}  // namespace candelabra
