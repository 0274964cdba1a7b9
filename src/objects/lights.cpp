// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/lights.h"

#include "appearance/webs.h"
#include "interpret/array_data.h"
#include "objects/objects.h"
#include "reading/item_block.h"
#include "reading/transforms.h"

namespace candelabra {

namespace {

/// Reads looks_like { ... } and projected_through { ... }.
class LightObjects : public SimpleReader {
public:
    LightObjects(OpenBlock& block, PlacedLight& placed) : block_(block), placed_(placed) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block) return false;
        const bool window = element.word == "projected_through"_word;
        if (!window && element.word != "looks_like"_word) return false;
        Element inner = element;
        inner.word = "object"_word;
        ObjectHandle object = read_object(block_.binder, inner);
        block_.broken |= !object;
        if (!object) return true;
        if (window) {
            placed_.projected_through = std::move(object);
            return true;
        }
        placed_.looks_like = transformed(std::move(object), Transform::translation(location()));
        placed_.looks_like.edit().no_shadow = true;
        return true;
    }

    void add_words(WordList& words) const {
        words.insert(words.end(), {"looks_like", "projected_through"});
    }

private:
    Vec3 location() const { return placed_.light.location; }

    OpenBlock& block_;
    PlacedLight& placed_;
};

/// Finds the last of the words that select how light leaves the source; as in POV-Ray, it counts.
class LastBeam : public SimpleReader {
public:
    /// True, so that it sees all elements. It takes none.
    bool waiting() const { return true; }
    bool take(const Element& element) {
        if (element.word == "shadowless"_word) shadowless_ = element.word_span;
        if (element.word == "spotlight"_word || element.word == "cylinder"_word) {
            if (shadowless_) undone_ = shadowless_;
            shadowless_.reset();
            beam_ = true;
        }
        return false;
    }

    /// The `shadowless` that a later word has cancelled.
    const std::optional<Span>& undone() const { return undone_; }
    /// Whether the light has shadows in spite of an earlier `shadowless`.
    bool has_shadows() const { return beam_ && !shadowless_; }

private:
    std::optional<Span> shadowless_, undone_;
    bool beam_ = false;
};

}  // namespace

bool is_lamp(const Binder& binder, const Element& element) {
    const auto& [tree, first] = element.body;
    if (element.word != "light_source"_word || !tree || first == no_node) return false;
    const auto* name = tree->get_if<node::Name>(first);
    const auto* index = tree->get_if<node::Index>(first);
    const Value* value = name    ? binder.evaluator.find(name->name)
                         : index ? binder.evaluator.find(index->name)
                                 : nullptr;
    if (!value) return false;
    const ArrayData* array = index ? value->array() : nullptr;
    return (array ? array->other(array->size()) : *value).handle<Object>() != nullptr;
}

std::optional<PlacedLight> read_light(Binder& binder, const Element& element) {
    OpenBlock block(binder, "light_source", element.word_span);
    PlacedLight placed{PointLight(), element.span};
    block.item = &PointLight::vocabulary;
    ItemReader fields(block, *block.item, &placed.light);
    auto declared = named<PlacedLight>(block, [&](const Handle<PlacedLight>& other) {
        placed = *other;
        placed.span = element.span;
        fields.rebind(*block.item, &placed.light);
        fields.complete();
        block.ignored = "color";
    });
    const auto apply = [&](const Transform& transform) {
        placed = transformed(std::move(placed), transform);
    };
    TransformReader moves(block, apply);
    LightObjects look(block, placed);
    LastBeam last;
    ItemBlock photons(block, LightPhotons::vocabulary, &placed.photons);
    block.read(element.body, declared, last, fields, look, moves, photons);
    if (block.broken) return std::nullopt;
    if (last.has_shadows()) {
        placed.light.shadowless = false;
        if (last.undone())
            block.report(warning(Fault::no_effect, *last.undone(),
                                 "`shadowless` has no effect: the kind of light that follows it "
                                 "has shadows"));
    }
    const bool modern = binder.evaluator.version() >= modern_version;
    placed.light.fades_from_source = modern;
    load_web(block, placed.light);
    if (block.broken) return std::nullopt;
    // A light without a colour is white, but one that is stated as black is off.
    PointLight& light = placed.light;
    if (light.is_measured() && fields.positional_given() > 1 && light.colour == Rgb(0))
        (light.intensity ? light.intensity : light.flux) = 0.0;
    if (std::string wrong = measure(light); !wrong.empty())
        block.report(
            error(Fault::misplaced, element.word_span, std::move(wrong))
                .with_help("light_source { 2*y rgb kelvin(2700) intensity candela(1000) }"));
    if (is_aimless(placed.light)) {
        placed.light.colour = Rgb(0);
        block.report(warning(Fault::degenerate, element.word_span,
                             "this light lights nothing: `point_at` is its own location")
                         .with_help(block.help()));
    }
    const std::string idle = ignored(placed.light);
    if (!idle.empty()) block.report(warning(Fault::no_effect, element.word_span, idle));
    return block.broken ? std::nullopt : std::optional(std::move(placed));
}

}  // namespace candelabra
