// SPDX-License-Identifier: GPL-3.0-or-later
// Reads texture_list { ... } of meshes: textures that faces select by number, or those of a
// triangle's corners. Called by the readers of objects and parts.
#pragma once

#include "reading/block.h"

#include <optional>

namespace candelabra {

/// Number of textures in a list.
enum class TextureCount {
    said,  ///< given by its first value
    three,
};

/// Reads the textures, each a block or a declared one; returns nothing after a diagnostic.
std::optional<std::vector<Handle<Texture>>> read_texture_list(OpenBlock& around,
                                                              const Element& block, TextureCount);

/// Reports faces of a mesh whose texture number is not below `count`.
void check_texture_numbers(OpenBlock&, const Shape&, std::size_t count);

}  // namespace candelabra
