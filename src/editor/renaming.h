// SPDX-License-Identifier: GPL-3.0-or-later
// Where a name is mentioned, and what changes when it gets another. A name means whatever was
// declared last where it is used, so all of its mentions are renamed together, in all files that
// belong together but those of the library.
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

/// Of the name at the place, in the file and those around it; empty when there is none.
std::vector<Mention> mentions(Workspace&, const std::string& path, std::uint32_t offset);

/// The mentions that are to be replaced, or why the name cannot become the new one.
std::variant<std::vector<Mention>, std::string> renaming(Workspace&, const std::string& path,
                                                         std::uint32_t offset,
                                                         const std::string& new_name);

}  // namespace candelabra
