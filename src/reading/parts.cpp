// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/parts.h"

#include "reading/item_reader.h"
#include "reading/transforms.h"

#include <algorithm>

namespace candelabra {

namespace {

constexpr std::string_view effectless_in_parts = "sturm hierarchy";

/// Offers the elements of a part to the looks of its shape; null: its parts have none.
class PartLookReader : public SimpleReader {
public:
    PartLookReader(OpenBlock& part, PartLooks* looks) : looks_(looks) {
        if (looks_) looks_->begin(part);
    }

    bool take(const Element& element) {
        return looks_ && element.kind == Element::Kind::block && looks_->take(element);
    }
    void add_words(WordList& words) const {
        if (looks_) words.insert(words.end(), {"texture", "pigment", "normal", "finish"});
    }

private:
    PartLooks* looks_;
};

}  // namespace

void read_part(OpenBlock& block, const FieldInfo& field, void* item, const Element& element) {
    const ItemInfo& info = field.parts->info();
    OpenBlock inner(block.binder, field.name, element.word_span);
    inner.item = &info;
    inner.ignored = effectless_in_parts;
    PartLooks* const looks = field.parts->look ? block.part_looks : nullptr;
    void* const part = field.parts->add(item);
    Transform* const place = field.parts->transform ? field.parts->transform(part) : nullptr;
    ItemReader fields(inner, info, part);
    PartLookReader look(inner, looks);
    if (place) {
        const auto apply = [&](const Movement& movement) {
            *place = place->then(movement.transform);
            if (looks) looks->move(movement.transform);
        };
        TransformReader moves(inner, apply);
        inner.read(element.body, fields, look, moves);
    } else {
        inner.read(element.body, fields, look);
    }
    if (looks)
        looks->number(field.parts->look(part), field.parts->looks);
    else if (field.parts->look)
        std::fill_n(field.parts->look(part), field.parts->looks, -1);
    block.broken |= inner.broken;
}

}  // namespace candelabra
