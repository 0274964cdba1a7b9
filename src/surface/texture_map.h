// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of a texture with a pattern, for code that makes, evaluates or writes one.
#pragma once

#include "pattern/use.h"
#include "surface/texture.h"

namespace candelabra {

/// One entry of a texture map. For `average` the value is a weight.
struct TextureStop {
    double value = 0;
    Handle<Texture> texture;
};
using TextureMap = std::vector<TextureStop>;

/// A pattern with the textures that it selects.
struct PatternedTexture {
    /// Precondition: the map is not empty; weights of an average are not negative and not all 0.
    PatternedTexture(PatternUse, const Transform&, TextureMap);

    PatternUse use;
    Transform transform;           ///< after all steps of the pattern: to the object's space
    bool uv = false;               ///< as in Pigment
    Handle<Transform> frame = {};  ///< as in Bump
    TextureMap map;
    Nesting nesting;
};

}  // namespace candelabra
