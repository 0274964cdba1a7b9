// SPDX-License-Identifier: GPL-3.0-or-later
// A search through all finishes of a texture.
#pragma once

#include "surface/texture_map.h"

#include <algorithm>

namespace candelabra {

/// Whether the test holds for a finish of any entry or layer.
template <class Test>
bool any_finish(const Texture& texture, const Test& test) {
    if (texture.choice)
        return std::ranges::any_of(texture.choice->map, [&](const TextureStop& stop) {
            return any_finish(*stop.texture, test);
        });
    return test(texture.finish) || (texture.below && any_finish(*texture.below, test));
}

}  // namespace candelabra
