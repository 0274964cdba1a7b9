// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the shell that POV-Ray's INI files have run before and after pictures. They come from
// the user's own options, never from a scene, and run only when --allow-commands says so.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace candelabra {

/// When a command is run.
enum class Moment { pre_scene, pre_frame, post_frame, post_scene, user_abort, fatal_error };
inline constexpr std::size_t moment_count = 6;

/// What comes after a command that failed (or succeeded, when inverted): POV-Ray's letters.
enum class After : char {
    ignore = 'I',
    skip = 'S',  ///< this picture, or all of them when no frame is at hand
    all = 'A',   ///< pictures that follow are skipped, too
    quit = 'Q',  ///< the run ends as if it were done
    abort = 'U',
    fatal = 'F',
};

struct CommandSettings {
    struct One {
        std::string command;  ///< empty: none
        std::string given;    ///< the option, with its place, for messages
        After after = After::ignore;
        bool inverted = false;  ///< a success has the consequence
    };
    std::array<One, moment_count> all;
    bool allowed = false;

    const One& operator[](Moment moment) const { return all[static_cast<std::size_t>(moment)]; }
    One& operator[](Moment moment) { return all[static_cast<std::size_t>(moment)]; }
    bool any() const;
};

/// What a command is told: %o the picture's file, %s the scene without its ending, %n the frame's
/// number, %k the clock, %w and %h the size, %% a percent sign.
struct CommandFacts {
    std::string output, scene;
    int frame = 0;
    double clock = 0;
    int width = 0, height = 0;
};

/// The command with its facts, each as one word of the shell.
std::string filled_in(std::string_view command, const CommandFacts&);

/// Runs the command of that moment, if there is one.
After run_command(const CommandSettings&, Moment, const CommandFacts&);

/// How a run goes on.
struct Outcome {
    int status = 0;     ///< of the program
    bool ends = false;  ///< no more pictures
};

/// Work between the commands of two moments, the second only when all went well; how errors and
/// interruptions end is told to their commands.
Outcome with_commands(const CommandSettings&, Moment before, Moment after, const CommandFacts&,
                      const std::function<Outcome()>& work);

}  // namespace candelabra
