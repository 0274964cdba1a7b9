// SPDX-License-Identifier: GPL-3.0-or-later
// Textures as they were written before version 3.0: the words of pigment, normal and finish stand
// in the texture itself, without blocks of their own. Used by the reader of textures.
#pragma once

#include "bind/textures.h"

namespace candelabra {

class LegacyTextureReader : public SimpleReader {
public:
    /// Both outlive the reader.
    LegacyTextureReader(OpenBlock& block, TextureDraft& draft) : block_(block), draft_(draft) {}

    /// Whether the scene may say textures so.
    static bool known_to(const Binder&);

    bool take(const Element&);
    /// Moves what has come so far, and a pattern that follows as well. False: not in such a scene.
    bool move(const Transform&);
    void finish() { settle(); }

private:
    void settle();
    void take_value(const Element&);
    void put(ElementList& part, const Element&);

    OpenBlock& block_;
    TextureDraft& draft_;
    ElementList pigment_, normal_, finish_;
    ElementList* part_ = nullptr;  ///< where the last word belongs
    int missing_ = 0;              ///< values of the last word that may still come
    Transform ahead_;              ///< what has moved it so far
};

}  // namespace candelabra
