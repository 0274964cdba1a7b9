// SPDX-License-Identifier: GPL-3.0-or-later
// Texts as words of a command line for the shell.
#pragma once

#include <string>
#include <string_view>

namespace candelabra {

/// Returns the text in single quotes, so that the shell (and ffmpeg in its lists) takes it as one
/// word.
std::string shell_quoted(std::string_view text);

/// Returns the text as one word of the shell, with quotes only if necessary.
std::string shell_word(std::string_view text);

}  // namespace candelabra
