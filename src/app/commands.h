// SPDX-License-Identifier: GPL-3.0-or-later
// What the program does with its options: renders, checks, dumps, explains. Everything it says goes
// through Console, so that tests can listen.
#pragma once

#include "app/options.h"

#include <functional>
#include <string>
#include <string_view>

/// What the shell is told.
namespace exit_status {
inline constexpr int done = 0;
inline constexpr int scene = 1;  ///< an error in the scene
inline constexpr int usage = 2;  ///< an error in the command line
inline constexpr int file = 3;   ///< a file could not be read or written
}  // namespace exit_status

struct Console {
    std::function<void(std::string_view)> out;  ///< results: dumps, help
    std::function<void(std::string_view)> err;  ///< diagnostics, progress
    bool terminal = false;                      ///< err can rewrite its line
    bool coloured = false;
    std::string library;   ///< folder of the standard library; empty: none
    std::string settings;  ///< INI file that is read before the command line; empty: none
};

/// Does what the program's arguments (without its name) ask for; gives the exit status.
int run(std::span<const std::string_view> arguments, const Console&);
