// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the textures of the parts of a shape, such as the triangles of a mesh. Used by the reader
// of objects.
#pragma once

#include "appearance/textures.h"
#include "reading/parts.h"

namespace candelabra {

class PartTextureReader : public PartLooks {
public:
    /// Adds the textures of all parts to the list, each once. It outlives the reader.
    PartTextureReader(Binder& binder, std::vector<Handle<Texture>>& list)
        : list_(list), draft_(binder.default_texture) {}

    void begin(OpenBlock& part) override;
    bool take(const Element&) override;
    void move(const Transform&) override;
    void number(int* looks, int count) override;

private:
    int number_of(const Handle<Texture>&);

    std::vector<Handle<Texture>>& list_;
    OpenBlock* part_ = nullptr;
    TextureDraft draft_;
    std::vector<Handle<Texture>> corners_;  ///< from a texture_list
    bool given_ = false;
};

}  // namespace candelabra
