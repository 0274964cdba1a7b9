// SPDX-License-Identifier: GPL-3.0-or-later
// Reads `photons { ... }` of an object. Used by the reader of objects.
#pragma once

#include "objects/object_draft.h"
#include "reading/item_reader.h"

namespace candelabra {

class PhotonsReader : public SimpleReader {
public:
    PhotonsReader(OpenBlock& block, ObjectDraft& draft) : block_(block), draft_(draft) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || element.word != "photons"_word) return false;
        read(element);
        draft_.modified = true;
        return true;
    }

    void add_words(WordList& words) const { words.push_back("photons"); }

private:
    /// Starts from the settings of a declared object, if there are any.
    [[gnu::noinline]] void read(const Element& element) {
        OpenBlock inner(block_.binder, "photons", element.word_span);
        inner.item = &ObjectPhotons::vocabulary;
        Handle<ObjectPhotons>& photons = draft_.switches.photons;
        ObjectPhotons made = photons ? *photons : ObjectPhotons();
        ItemReader fields(inner, *inner.item, &made);
        fields.alone("target", 1);
        inner.read(element.body, fields);
        block_.broken |= inner.broken;
        photons = made == ObjectPhotons() ? nullptr : make_handle<ObjectPhotons>(made);
    }

    OpenBlock& block_;
    ObjectDraft& draft_;
};

}  // namespace candelabra
