// SPDX-License-Identifier: GPL-3.0-or-later
// Shell commands that run before and after pictures, as in POV-Ray's INI files. They come from the
// user's own options, never from a scene, and run only with --allow-commands.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

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
    bool any() const;
};

/// Values for the escapes in a command: %o the picture's file, %s the scene without its extension,
/// %n the frame's number, %k the clock, %w and %h the size, %% a percent sign.
struct CommandFacts {
    std::string output, scene;
    int frame = 0;
    double clock = 0;
    int width = 0, height = 0;
};

/// Replaces the escapes in the command, each by one word of the shell.
std::string filled_in(std::string_view command, const CommandFacts&);

/// Runs the command for that moment, if there is one. Returns the action to take.
After run_command(const CommandSettings&, Moment, const CommandFacts&);

/// The continuation of a run.
struct Outcome {
    int status = 0;     ///< of the program
    bool ends = false;  ///< no more pictures
};

/// Does work between two commands, the second only if everything succeeded. On errors and
/// interruptions their commands are run.
Outcome with_commands(const CommandSettings&, Moment before, Moment after, const CommandFacts&,
                      const std::function<Outcome()>& work);

}  // namespace candelabra
