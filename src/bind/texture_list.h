// SPDX-License-Identifier: GPL-3.0-or-later
// texture_list { ... } of meshes: textures that faces name by number, or those of a triangle's
// corners. Called by the readers of objects and parts.
#pragma once

#include "bind/block.h"

#include <optional>

namespace candelabra {

/// How many textures a list has.
enum class TextureCount {
    said,  ///< as its first value says
    three,
};

/// The textures, which may be blocks or declared ones; nothing after a report.
std::optional<std::vector<Handle<Texture>>> read_texture_list(OpenBlock& around,
                                                              const Element& block, TextureCount);

/// Reports when a face of a mesh names a texture that is not one of so many.
void check_texture_numbers(OpenBlock&, const Shape&, std::size_t count);

}  // namespace candelabra
