// SPDX-License-Identifier: GPL-3.0-or-later
// Help on the word at a place, as Markdown: the vocabulary's descriptions of items, fields and
// functions; for a name, its declaration and the comment above it.
#pragma once

#include "editor/workspace.h"

#include <optional>
#include <string>

namespace candelabra {

struct Hover {
    std::string text;
    Part place;
};

std::optional<Hover> hover(Workspace&, const std::string& path, std::uint32_t offset);

/// Returns the names of the blocks around a place, innermost first: "finish", "texture", "sphere".
std::vector<NameId> blocks_around(const EditedFile&, std::uint32_t offset);

}  // namespace candelabra
