// SPDX-License-Identifier: GPL-3.0-or-later
// Fonts that are installed on this computer. Called for a `text` object whose font is neither
// beside the scene nor in the library.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// Returns the content of the font file with this name; nothing if there is none.
std::optional<std::string> system_font(const std::string& file_name);

/// File names of free fonts that resemble the given font of POV-Ray's, the best match first. They
/// replace it on computers where it is not installed. Empty for any other font.
std::span<const char* const> fonts_like(std::string_view file_name);

}  // namespace candelabra
