// SPDX-License-Identifier: GPL-3.0-or-later
// Completion scripts for shells, made from the table of options. The build writes them with
// --completion.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the script for bash, zsh or fish, or nothing for another shell.
std::optional<std::string> completion(std::string_view shell);

}  // namespace candelabra
