// SPDX-License-Identifier: GPL-3.0-or-later
// Textures by content: a loop that writes the same plain texture a million times gets one. Called
// by the readers of objects.
#pragma once

#include "scene/scene.h"

#include <vector>

class TextureStore {
public:
    /// A handle to an equal texture, perhaps the same one. Patterned ones are not compared: they
    /// are rarely equal.
    Handle<Texture> share(Handle<Texture>);

private:
    Handle<Texture>& slot(const Texture&);
    void grow();

    std::vector<Handle<Texture>>
        slots_;  ///< open addressing; a power of two, at most half of them taken
    std::size_t count_ = 0;
};
