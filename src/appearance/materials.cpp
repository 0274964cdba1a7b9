// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/materials.h"

#include "reading/transforms.h"

namespace candelabra {

namespace {

/// Reads the textures and the interior of a material.
class MaterialReader : public SimpleReader {
public:
    MaterialReader(OpenBlock& block, DeclaredMaterial& material)
        : block_(block), material_(material) {}

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value) return take_declared(element);
        if (element.kind != Element::Kind::block) return false;
        if (element.word == "texture"_word) {
            take_texture(element, material_.texture, inherited_);
        } else if (element.word == "interior_texture"_word) {
            take_texture(element, material_.interior_texture, inherited_inner_);
        } else if (element.word == "interior"_word) {
            Interior interior = material_.interior ? *material_.interior : Interior{};
            block_.broken |= !read_interior(block_.binder, element, interior);
            material_.interior = make_handle<Interior>(interior);
        } else {
            return false;
        }
        return true;
    }

    void add_words(WordList& words) const {
        words.insert(words.end(), {"texture", "interior_texture", "interior"});
    }

private:
    bool take_declared(const Element& element) {
        if (const auto texture = element.value.handle<Texture>())
            put_on(texture, element.span, material_.texture, inherited_);
        else if (const auto interior = element.value.handle<Interior>())
            material_.interior = interior;
        else
            return false;
        return true;
    }

    void take_texture(const Element& element, Handle<Texture>& below, bool& inherited) {
        Handle<Texture> texture = read_whole_texture(block_.binder, element);
        block_.broken |= !texture;
        if (texture) put_on(std::move(texture), element.word_span, below, inherited);
    }

    void put_on(Handle<Texture> texture, Span span, Handle<Texture>& below, bool& inherited) {
        below = below && !inherited ? layered(block_, span, below, std::move(texture))
                                    : std::move(texture);
        inherited = false;
    }

    OpenBlock& block_;
    DeclaredMaterial& material_;
    // The texture comes from a declared material: another one replaces it instead of lying over it.
    bool inherited_ = material_.texture != nullptr;
    bool inherited_inner_ = material_.interior_texture != nullptr;
};

}  // namespace

bool read_material(Binder& binder, const Element& element, DeclaredMaterial& material) {
    OpenBlock block(binder, "material", element.word_span);
    block.form =
        "{ [Name] texture { ... } [interior_texture { ... }] interior { ... } [transformations] }";
    auto declared = named<DeclaredMaterial>(
        block, [&](const Handle<DeclaredMaterial>& other) { material = *other; });
    MaterialReader parts(block, material);
    // As in POV-Ray, the inner texture is not transformed.
    const auto apply = [&](const Transform& transform) {
        if (material.interior && candelabra::moves(*material.interior))
            material.interior = make_handle<Interior>(transformed(*material.interior, transform));
        if (!material.texture) return;
        TextureDraft draft(material.texture);
        draft.move(transform);
        material.texture = draft.handle();
    };
    TransformReader moves(block, apply);
    block.read(element.body, declared, parts, moves);
    return !block.broken;
}

}  // namespace candelabra
