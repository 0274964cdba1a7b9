// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts that are installed on this computer. Called for a `text` whose font lies neither beside
// the scene nor in the library.
#pragma once

#include <optional>
#include <string>

namespace candelabra {

/// The content of the font file with this name; nothing when there is none.
std::optional<std::string> system_font(const std::string& file_name);

}  // namespace candelabra
