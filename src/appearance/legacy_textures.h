// SPDX-License-Identifier: GPL-3.0-or-later
// Reads textures as written before version 3.0: the words of pigment, normal and finish stand in
// the texture itself, without blocks of their own. Used by the reader of textures.
#pragma once

#include "appearance/textures.h"

namespace candelabra {

class LegacyTextureReader : public SimpleReader {
public:
    /// Both arguments outlive the reader.
    LegacyTextureReader(OpenBlock& block, TextureDraft& draft) : block_(block), draft_(draft) {}

    /// Whether the scene's version allows such textures.
    static bool known_to(const Binder&);

    bool take(const Element&);
    /// Transforms the words read so far, and a pattern that follows. Returns false if the scene's
    /// version does not allow such textures.
    bool move(const Transform&);
    void finish() { settle(); }

private:
    void settle();
    void take_value(const Element&);
    void put(ElementList& part, const Element&);

    OpenBlock& block_;
    TextureDraft& draft_;
    ElementList pigment_, normal_, finish_;
    ElementList* part_ = nullptr;  ///< the part that the last word belongs to
    int missing_ = 0;              ///< number of values that the last word may still take
    Transform ahead_;              ///< composition of the transformations so far
};

}  // namespace candelabra
