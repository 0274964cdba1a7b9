// SPDX-License-Identifier: GPL-3.0-or-later
// Reads clipped_by, whose objects cut an object, and bounded_by, whose objects a ray must hit to
// see it. Called by the reader of objects.
#pragma once

#include "objects/object_draft.h"

namespace candelabra {

class ClippingReader : public SimpleReader {
public:
    ClippingReader(OpenBlock& block, ObjectDraft& draft) : block_(block), draft_(draft) {}

    bool take(const Element&);
    void add_words(WordList& words) const {
        words.insert(words.end(), {"clipped_by", "bounded_by"});
    }

private:
    OpenBlock& block_;
    ObjectDraft& draft_;
};

}  // namespace candelabra
