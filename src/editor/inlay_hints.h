// SPDX-License-Identifier: GPL-3.0-or-later
// Names of parameters before the arguments of macros, which an editor shows between the letters of
// the text.
#pragma once

#include "editor/workspace.h"

#include <cstdint>
#include <string>
#include <vector>

namespace candelabra {

struct InlayHint {
    std::uint32_t offset;  ///< of the argument
    std::string name;      ///< of its parameter
};

/// Returns the hints of a part of the file, in order. An argument that is a name equal to that of
/// its parameter has none.
std::vector<InlayHint> inlay_hints(Workspace&, const std::string& path, Part);

}  // namespace candelabra
