// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the macro or function whose call is being typed.
#pragma once

#include "editor/workspace.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

struct Signature {
    std::string label;                    ///< Light_Ring(Lamp, Count, Radius)
    std::vector<std::string> parameters;  ///< parts of the label
    std::size_t active = 0;               ///< the argument that the place is in, from 0
    std::string help;                     ///< may be empty
};

/// Nothing where the place is in no call.
std::optional<Signature> signature_at(Workspace&, const std::string& path, std::uint32_t offset);

}  // namespace candelabra
