// SPDX-License-Identifier: GPL-3.0-or-later
// Completion for shells, made from the table of options. Written by the build with --completion.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candelabra {

/// The script for bash, zsh or fish; nothing for another shell.
std::optional<std::string> completion(std::string_view shell);

}  // namespace candelabra
