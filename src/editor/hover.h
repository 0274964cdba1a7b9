// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to say about the word at a place: the vocabulary's own words for items, fields and
// functions; for a name its declaration, and the comment above it. Markdown.
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

/// The names of the blocks that a place lies in, the innermost first: "finish", "texture",
/// "sphere".
std::vector<NameId> blocks_around(const EditedFile&, std::uint32_t offset);

}  // namespace candelabra
