// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/parts.h"

#include "bind/normals.h"
#include "bind/texture_list.h"
#include "bind/textures.h"
#include "bind/transforms.h"

#include <algorithm>

namespace candelabra {

namespace {

constexpr std::string_view effectless_in_parts = "sturm hierarchy";

/// Reads the texture, pigment, normal and finish of a part.
class PartLookReader : public SimpleReader {
public:
    explicit PartLookReader(OpenBlock& block)
        : block_(block), draft_(block.binder.default_texture) {}

    bool take(const Element& element) {
        if (!block_.part_textures || element.kind != Element::Kind::block) return false;
        bool good = true;
        if (element.word == "texture_list"_word) {
            std::optional<std::vector<Handle<Texture>>> list =
                read_texture_list(block_, element, TextureCount::three);
            if (list) corners_ = std::move(*list);
            return true;
        }
        if (element.word == "texture"_word)
            good = read_texture(block_.binder, element, draft_);
        else if (element.word == "pigment"_word)
            good = read_pigment(block_.binder, element, draft_.edit().pigment);
        else if (element.word == "normal"_word)
            good = read_normal(block_.binder, element, draft_.edit().normal);
        else if (element.word == "finish"_word)
            good = read_finish(block_.binder, element, draft_.edit().finish);
        else
            return false;
        given_ = true;
        block_.broken |= !good;
        return true;
    }
    void move(const Transform& transform) {
        if (given_ && draft_.movable()) draft_.edit() = transformed(draft_.now(), transform);
    }
    void add_words(WordList& words) const {
        if (block_.part_textures)
            words.insert(words.end(), {"texture", "pigment", "normal", "finish"});
    }
    /// Stores the indices of the part's textures in the list, or -1.
    void number(int* looks, int count) {
        const int one = given_ ? number(draft_.shared(block_.binder.textures)) : -1;
        for (int i = 0; i < count; ++i)
            looks[i] = corners_.empty() ? one : number(corners_[static_cast<std::size_t>(i)]);
    }

private:
    int number(const Handle<Texture>& texture) {
        std::vector<Handle<Texture>>& list = *block_.part_textures;
        const auto found = std::ranges::find(list, texture);
        if (found == list.end()) list.push_back(texture);
        return static_cast<int>(std::ranges::find(list, texture) - list.begin());
    }

    OpenBlock& block_;
    TextureDraft draft_;
    std::vector<Handle<Texture>> corners_;  ///< from a texture_list
    bool given_ = false;
};

}  // namespace

void read_part(OpenBlock& block, const FieldInfo& field, void* item, const Element& element) {
    const ItemInfo& info = field.parts->info();
    OpenBlock inner(block.binder, field.name, element.word_span);
    inner.item = &info;
    inner.ignored = effectless_in_parts;
    if (field.parts->look) inner.part_textures = block.part_textures;
    void* const part = field.parts->add(item);
    Transform* const place = field.parts->transform ? field.parts->transform(part) : nullptr;
    ItemReader fields(inner, info, part);
    PartLookReader looks(inner);
    if (place) {
        const auto apply = [&](const Movement& movement) {
            *place = place->then(movement.transform);
            looks.move(movement.transform);
        };
        TransformReader moves(inner, apply);
        inner.read(element.body, fields, looks, moves);
    } else {
        inner.read(element.body, fields, looks);
    }
    if (field.parts->look) looks.number(field.parts->look(part), field.parts->looks);
    block.broken |= inner.broken;
}

}  // namespace candelabra
