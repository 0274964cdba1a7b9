// SPDX-License-Identifier: GPL-3.0-or-later
// Who the program talks to, and what it answers in the end: main() fills it with the terminal and
// the system, tests with what they want to hear. Everything that the commands say goes through it.
#pragma once

#include "app/identity.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "render/film.h"

#include <functional>
#include <string>
#include <string_view>

/// What the shell is told.
namespace exit_status {
inline constexpr int done = 0;
inline constexpr int scene = 1;    ///< an error in the scene
inline constexpr int usage = 2;    ///< an error in the command line
inline constexpr int file = 3;     ///< a file could not be read or written
inline constexpr int stopped = 4;  ///< a signal ended the work, and its state was kept
}  // namespace exit_status

struct Console {
    std::function<void(std::string_view)> out;  ///< results: dumps, help
    std::function<void(std::string_view)> err;  ///< diagnostics, progress
    bool terminal = false;                      ///< err can rewrite its line
    bool coloured = false;
    std::string library;      ///< folder of the standard library; empty: none
    Interrupts interrupts;    ///< what signals ask
    Environment environment;  ///< variables; empty: there are none
    /// Who looks at pictures on their way, and at the files that they are made from; may be empty.
    std::function<void(const Film&, double done)> watch;
    std::function<void(const std::vector<ReadFile>&)> files_read;
    std::string settings;  ///< INI file that is read before the command line; empty: none
};

/// Writes all diagnostics to the console in the form that the options ask for.
void say_errors(const Console&, const Options&, const Diagnostics&);
