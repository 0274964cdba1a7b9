// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/textures.h"

#include "evaluate/normals.h"
#include "evaluate/transforms.h"
#include "vocabulary/manual.h"

namespace {

/// pigment { } and finish { } in a texture, or parts that were declared.
class PartReader : public SimpleReader {
public:
    PartReader(OpenBlock& block, TextureDraft& draft) : block_(block), draft_(draft) {}

    bool wants() const { return block_.taken == 0; }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value) return take_declared(element.value);
        if (element.kind != Element::Kind::block) return false;
        if (element.word == "pigment"_word)
            block_.broken |= !read_pigment(block_.binder, element, draft_.edit().pigment);
        else if (element.word == "normal"_word)
            block_.broken |= !read_normal(block_.binder, element, draft_.edit().normal);
        else if (element.word == "finish"_word)
            block_.broken |= !read_finish(block_.binder, element, draft_.edit().finish);
        else
            return false;
        return true;
    }

    void add_words(WordList& words) const {
        words.insert(words.end(), {"pigment", "normal", "finish"});
    }

private:
    bool take_declared(const Value& value) {
        if (const auto pigment = value.handle<Pigment>())
            draft_.edit().pigment = *pigment;
        else if (const auto normal = value.handle<Bump>())
            draft_.edit().normal = *normal;
        else if (const auto finish = value.handle<Finish>())
            draft_.edit().finish = *finish;
        else
            return false;
        return true;
    }

    OpenBlock& block_;
    TextureDraft& draft_;
};

/// reflection amount, reflection { ... }, reflection_exponent: the part of a finish that has two
/// forms.
class ReflectionReader {
public:
    ReflectionReader(OpenBlock& block, Reflection& reflection)
        : block_(block), reflection_(reflection) {}

    bool waiting() const { return waiting_; }
    bool wants() const { return waiting_; }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value && waiting_) {
            waiting_ = false;
            const auto value = converted(block_, element, FieldType::rgb,
                                         {[] { return std::string("`reflection` of `finish`"); },
                                          [] { return usage(Reflection::vocabulary); }});
            if (value) reflection_.least = reflection_.greatest = std::get<Vec3>(*value);
            return true;
        }
        const bool named =
            (element.kind == Element::Kind::word || element.kind == Element::Kind::block) &&
            element.word == "reflection"_word;
        const bool unknown = element.kind == Element::Kind::word &&
                             !block_.binder.evaluator.names().reserved(element.word);
        if (waiting_ && !unknown) finish();
        if (!named) return false;
        span_ = element.word_span;
        if (element.kind == Element::Kind::block)
            read(element);
        else
            waiting_ = true;
        return true;
    }

    void finish() {
        if (!std::exchange(waiting_, false)) return;
        block_.report(
            error(Fault::missing, span_, "`reflection` of `finish` needs a colour or a block")
                .with_help(usage(Reflection::vocabulary)));
    }

    void add_words(WordList& words) const { words.push_back("reflection"); }

private:
    void read(const Element& element) {
        OpenBlock inner(block_.binder, "reflection", element.word_span);
        inner.item = &Reflection::vocabulary;
        Reflection made;
        ItemReader fields(inner, *inner.item, &made);
        fields.alone("metallic", 1);
        inner.read(element.body, fields);
        if (fields.positional_given() < 2) {
            made.greatest = made.least;
            if (made.fresnel) made.least = Vec3(0);
        }
        block_.broken |= inner.broken;
        reflection_ = made;
    }

    OpenBlock& block_;
    Reflection& reflection_;
    bool waiting_ = false;
    Span span_;
};

}  // namespace

bool read_texture(Binder& binder, const Element& element, TextureDraft& draft) {
    OpenBlock block(binder, "texture", element.word_span);
    block.form = "{ [Name] pigment { ... } normal { ... } finish { ... } [transformations] }";
    auto declared =
        named<Texture>(block, [&](const Handle<Texture>& texture) { draft.replace(texture); });
    PartReader parts(block, draft);
    const auto apply = [&](const Transform& transform) { draft.move(transform); };
    TransformReader moves(block, apply);
    block.read(element.body, declared, parts, moves);
    return !block.broken;
}

bool read_finish(Binder& binder, const Element& element, Finish& finish) {
    OpenBlock block(binder, "finish", element.word_span);
    block.item = &Finish::vocabulary;
    auto declared = named<Finish>(block, [&](const Handle<Finish>& other) { finish = *other; });
    ItemReader fields(block, *block.item, &finish);
    fields.alone("metallic", 1);
    ReflectionReader reflection(block, finish.reflection);
    block.read(element.body, declared, fields, reflection);
    return !block.broken;
}

bool read_interior(Binder& binder, const Element& element, Interior& interior) {
    OpenBlock block(binder, "interior", element.word_span);
    block.item = &Interior::vocabulary;
    auto declared =
        named<Interior>(block, [&](const Handle<Interior>& other) { interior = *other; });
    ItemReader fields(block, *block.item, &interior);
    block.read(element.body, declared, fields);
    return !block.broken;
}

bool cover(OpenBlock& block, Span span, TextureDraft& below, Handle<Texture> above) {
    const Reflection& lower = below.now().finish.reflection;
    const bool hidden =
        !transparent(above->pigment) && lower.least == Vec3(0) && lower.greatest == Vec3(0);
    below.replace(std::move(above));
    if (hidden) return true;
    block.report(
        error(Fault::not_implemented, span, "layers of textures are not available in this version")
            .with_help(
                "this texture lets one below it be seen: give only one, or make this one opaque"));
    return false;
}
