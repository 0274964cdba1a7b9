// SPDX-License-Identifier: GPL-3.0-or-later
// Shell commands that run before and after pictures, as in POV-Ray's INI files. They come from the
// user's own options, never from a scene, and run only with --allow-commands.
#pragma once

#include "options/command_settings.h"

#include <functional>
#include <string>
#include <string_view>

namespace candelabra {

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
