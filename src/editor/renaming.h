// SPDX-License-Identifier: GPL-3.0-or-later
// Mentions of a name, and the changes when it is renamed. A name refers to its most recent
// declaration at run time, so all of its mentions are renamed together, in all related files except
// those of the library.
#pragma once

#include "editor/workspace.h"

#include <string>
#include <variant>
#include <vector>

namespace candelabra {

struct Mention {
    std::string path;
    Part place;
};

/// Returns the mentions of the name at the place, in the file and those around it; empty if none.
std::vector<Mention> mentions(Workspace&, const std::string& path, std::uint32_t offset);

/// Returns the mentions to replace, or the reason why the name cannot become the new one.
std::variant<std::vector<Mention>, std::string> renaming(Workspace&, const std::string& path,
                                                         std::uint32_t offset,
                                                         const std::string& new_name);

}  // namespace candelabra
