// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the macro or function in whose call the user is typing.
#pragma once

#include "editor/workspace.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

struct Signature {
    std::string label;                    ///< Light_Ring(Lamp, Count, Radius)
    std::vector<std::string> parameters;  ///< parts of the label
    std::size_t active = 0;               ///< index of the argument at the place, from 0
    std::string help;                     ///< may be empty
};

/// Returns nothing if the place is not inside a call.
std::optional<Signature> signature_at(Workspace&, const std::string& path, std::uint32_t offset);

}  // namespace candelabra
