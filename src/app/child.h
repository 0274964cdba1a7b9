// SPDX-License-Identifier: GPL-3.0-or-later
// Other programs that this one runs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// In single quotes, so that the shell (and ffmpeg in its lists) takes any text for one word.
std::string shell_quoted(std::string_view text);

/// The same without quotes where there is no need of them.
std::string shell_word(std::string_view text);

/// The program that the shell would find under this name, or "".
std::string find_program(const std::string& name);

/// Runs the program whose path is the first of the words, and waits for it: its exit status, or -1
/// when it could not be run or ended by a signal.
int run_program(const std::vector<std::string>& words);

}  // namespace candelabra
