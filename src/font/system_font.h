// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts that are installed on this computer. Called for a `text` whose font lies neither beside
// the scene nor in the library.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// The content of the font file with this name; nothing when there is none.
std::optional<std::string> system_font(const std::string& file_name);

/// Free fonts of the kind of one of POV-Ray's, by their file names, the best first: for computers
/// where that is not installed. Empty for all other fonts.
std::span<const char* const> fonts_like(std::string_view file_name);

}  // namespace candelabra
