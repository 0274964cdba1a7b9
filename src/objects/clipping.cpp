// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/clipping.h"

#include "base/long_work.h"
#include "objects/objects.h"
#include "text/message.h"

namespace candelabra {

namespace {

/// Reads the objects in the block, or the other word alone, which stands for the same objects.
class ObjectsReader : public SimpleReader {
public:
    ObjectsReader(OpenBlock& block, NameId other) : block_(block), other_(other) {}

    bool wants() const { return objects.empty() && !linked; }
    bool take(const Element& element) {
        if (element.kind == Element::Kind::word && element.word == other_) return linked = true;
        if (element.kind == Element::Kind::value) {
            const ObjectHandle object = element.value.handle<Object>();
            if (object) objects.push_back(object);
            return object != nullptr;
        }
        if (!block_.makes_object(element)) return false;
        ObjectHandle made = read_object(block_.binder, element);
        block_.broken |= !made;
        if (made) objects.push_back(std::move(made));
        return true;
    }
    void finish() {
        if (block_.broken || !wants()) return;
        block_.report(
            error(Fault::missing, block_.span, message(block_.quoted(), " needs an object"))
                .with_help(block_.help()));
    }
    void add_words(WordList& words) const {
        for (const ItemInfo* shape : Kinds<Shape>::infos) words.push_back(shape->name);
        words.insert(words.end(), {"union", "object"});
    }

    std::vector<ObjectHandle> objects;
    bool linked = false;

private:
    OpenBlock& block_;
    NameId other_;
};

}  // namespace

bool ClippingReader::take(const Element& element) {
    const bool clips = element.word == "clipped_by"_word;
    if (element.kind != Element::Kind::block || !(clips || element.word == "bounded_by"_word))
        return false;
    OpenBlock inner(block_.binder, block_.spelling(element.word), element.word_span);
    inner.form =
        clips ? "{ objects ... }, or { bounded_by }" : "{ objects ... }, or { clipped_by }";
    ObjectsReader reader(inner, clips ? "bounded_by"_word : "clipped_by"_word);
    inner.read(element.body, reader);
    block_.broken |= inner.broken;
    draft_.modified = draft_.clipped = true;
    Clipping& clipping = draft_.clipping;
    auto& list = clips ? clipping.clips : clipping.bounds;
    const auto& other = clips ? clipping.bounds : clipping.clips;
    const auto& added = reader.linked ? other : reader.objects;
    for (const ObjectHandle& each : added)
        if (!may_be_cut(block_, *each)) return true;
    count_long_work(list.size() / 4 + added.size());
    list.insert(list.end(), added.begin(), added.end());
    return true;
}

}  // namespace candelabra
