// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands of the program, and the options that they have besides those of a run, as one
// table. Their reading and the completion of shells are made from it.
#pragma once

#include "text/diagnostic.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// An option of a subcommand, written `--name VALUE`, `--name=VALUE`, or `--name` alone.
struct SubcommandOption {
    std::string_view name;  ///< with its dashes; `--output` is `-o` and `+O`, too
    std::string_view help;
    std::string_view parameter = {};  ///< what its value is, such as `file`; empty: it has none
};

struct Subcommand {
    std::string_view name;
    std::string_view help;     ///< what it does
    std::string_view endings;  ///< of the files that it reads, divided by `|`; empty: none
    bool takes_run = false;    ///< whether it takes options of a run as well
    std::span<const SubcommandOption> options = {};
    std::span<const SubcommandOption> shared = {};  ///< that other subcommands have as well
};

/// All options of a subcommand.
std::vector<SubcommandOption> options_of(const Subcommand&);

/// In the order in which help names them.
std::span<const Subcommand> subcommands();

/// Hands each option of the subcommand to `take`, in their order, with its value, and returns the
/// other arguments; those from `--` on are never options. A subcommand without `--output` gets it
/// as an option of a run, `+OVALUE`. Reports options without their value.
std::vector<std::string> take_options(
    std::string_view subcommand, std::span<const std::string_view> arguments,
    const std::function<void(std::string_view name, std::string value)>& take, Diagnostics&);

}  // namespace candelabra
