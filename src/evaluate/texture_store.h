// SPDX-License-Identifier: GPL-3.0-or-later
// Textures by content: a loop that writes the same plain texture a million times gets one. Called
// by the readers of objects.
#pragma once

#include "scene/scene.h"

#include <memory>
#include <unordered_map>

class TextureStore {
public:
    /// A handle to an equal texture. Patterned ones are not compared: they are rarely equal.
    Handle<Texture> share(Texture);

private:
    std::unordered_multimap<std::size_t, Handle<Texture>> plain_;
};
