// SPDX-License-Identifier: GPL-3.0-or-later
// Runs other programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// Returns the text in single quotes, so that the shell (and ffmpeg in its lists) takes it as one
/// word.
std::string shell_quoted(std::string_view text);

/// Returns the text as one word of the shell, with quotes only if necessary.
std::string shell_word(std::string_view text);

/// Returns the path of the program that the shell would find under this name, or "".
std::string find_program(const std::string& name);

/// Runs the program whose path is the first word and waits for it. Returns its exit status, or -1
/// if it could not be run or was ended by a signal.
int run_program(const std::vector<std::string>& words);

}  // namespace candelabra
