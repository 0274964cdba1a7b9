// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the parts of an object's block that give its appearance. Used by the reader of objects.
#pragma once

#include "appearance/materials.h"
#include "appearance/normals.h"
#include "appearance/texture_list.h"
#include "objects/object_draft.h"

namespace candelabra {

/// Reads the texture, pigment, normal, finish, interior and material of an object.
class AppearanceReader : public SimpleReader {
public:
    AppearanceReader(OpenBlock& block, ObjectDraft& draft) : block_(block), draft_(draft) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block) return false;
        bool good = true;
        if (element.word == "pigment"_word)
            good = change(element, [&](TextureDraft& draft) {
                return read_pigment(block_.binder, element, draft.edit().pigment);
            });
        else if (element.word == "normal"_word)
            good = change(element, [&](TextureDraft& draft) {
                return read_normal(block_.binder, element, draft.edit().normal);
            });
        else if (element.word == "finish"_word)
            good = change(element, [&](TextureDraft& draft) {
                return read_finish(block_.binder, element, draft.edit().finish);
            });
        else if (element.word == "texture"_word)
            good = take_texture(element);
        else if (element.word == "interior_texture"_word)
            good = take_interior_texture(element);
        else if (element.word == "interior"_word)
            good = take_interior(element);
        else if (element.word == "material"_word)
            good = take_material(element);
        else if (element.word == "texture_list"_word && block_.name == "mesh2")
            good = take_list(element);
        else
            return false;
        draft_.modified = true;
        block_.broken |= !good;
        return true;
    }

    void add_words(WordList& words) const {
        words.insert(words.end(), {"texture", "interior_texture", "pigment", "normal", "finish",
                                   "interior", "material"});
    }

private:
    TextureDraft& own() {
        draft_.textured = draft_.retextured = true;
        return draft_.texture;
    }

    /// Changes the object's texture by read(TextureDraft&), which returns whether it succeeded.
    template <class Read>
    bool change(const Element& element, Read read) {
        const auto constant = block_.binder.constants.number(element);
        if (!constant) return read(own());
        const Handle<Texture> changed = made_of(constant, own().handle(), read);
        if (changed) draft_.texture.replace(changed);
        return changed != nullptr;
    }

    template <class Read>
    Handle<Texture> made_of(std::optional<std::uint64_t> element, Handle<Texture> base, Read read) {
        return block_.binder.appearances.made(element, base, [&]() -> Handle<Texture> {
            TextureDraft draft(base);
            return read(draft) ? draft.shared(block_.binder.textures) : nullptr;
        });
    }

    bool take_texture(const Element& element) {
        const Handle<Texture> texture =
            made_of(block_.binder.constants.number(element), block_.binder.default_texture,
                    [&](TextureDraft& made) { return read_texture(block_.binder, element, made); });
        if (!texture) return false;
        put_on(texture, element.word_span);
        return true;
    }

    bool take_interior_texture(const Element& element) {
        Handle<Texture> made = read_whole_texture(block_.binder, element);
        if (!made) return false;
        line_with(std::move(made), element.word_span);
        return true;
    }

    /// Layers the texture over those that the object has already.
    void put_on(Handle<Texture> texture, Span span) {
        if (draft_.textured) texture = layered(block_, span, draft_.texture.handle(), texture);
        own().replace(std::move(texture));
    }

    /// Layers the texture over the inner textures that stand before it in the block.
    void line_with(Handle<Texture> texture, Span span) {
        if (lined_) texture = layered(block_, span, draft_.interior_texture, std::move(texture));
        draft_.interior_texture = std::move(texture);
        draft_.retextured = lined_ = true;
    }

    bool take_material(const Element& element) {
        DeclaredMaterial material;
        if (!read_material(block_.binder, element, material)) return false;
        if (material.texture) put_on(material.texture, element.word_span);
        if (material.interior_texture) line_with(material.interior_texture, element.word_span);
        if (material.interior) {
            draft_.made.edit().interior = material.interior;
            draft_.furnished = true;
        }
        return true;
    }

    bool take_interior(const Element& element) {
        Handle<Interior>& interior = draft_.made.edit().interior;
        draft_.furnished = true;
        const Handle<Interior> changed = block_.binder.interiors.made(
            block_.binder.constants.number(element), interior, [&]() -> Handle<Interior> {
                Interior made = interior ? *interior : Interior{};
                return read_interior(block_.binder, element, made) ? make_handle<Interior>(made)
                                                                   : nullptr;
            });
        if (changed) interior = changed;
        return changed != nullptr;
    }

    /// Reads the textures of a mesh's faces.
    bool take_list(const Element& element) {
        auto list = read_texture_list(block_, element, TextureCount::said);
        if (list) draft_.part_textures = std::move(*list);
        return list.has_value();
    }

    OpenBlock& block_;
    ObjectDraft& draft_;
    bool lined_ = false;  ///< whether this block has given an inner texture
};

}  // namespace candelabra
