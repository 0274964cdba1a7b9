// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/lights.h"

#include "evaluate/objects.h"
#include "evaluate/transforms.h"

namespace {

/// looks_like { ... }, projected_through { ... }
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
        placed_.looks_like = moved(std::move(object), Transform::translation(location()));
        placed_.looks_like.edit().no_shadow = true;
        return true;
    }

    void add_words(WordList& words) const {
        words.insert(words.end(), {"looks_like", "projected_through"});
    }

private:
    Vec3 location() const {
        return std::visit([](const auto& light) { return light.location; }, placed_.light);
    }

    OpenBlock& block_;
    PlacedLight& placed_;
};

}  // namespace

std::optional<PlacedLight> read_light(Binder& binder, const Element& element) {
    OpenBlock block(binder, "light_source", element.word_span);
    block.effectless = "media_interaction photons";
    PlacedLight placed{Kinds<Light>::make(0), element.span};
    block.item = Kinds<Light>::infos[0];
    ItemReader fields(block, *block.item, Kinds<Light>::address(placed.light));
    auto declared = named<PlacedLight>(block, [&](const Handle<PlacedLight>& other) {
        placed = *other;
        placed.span = element.span;
        fields.rebind(*Kinds<Light>::infos[placed.light.index()],
                      Kinds<Light>::address(placed.light));
        fields.complete();
    });
    const auto apply = [&](const Transform& transform) {
        placed = moved(std::move(placed), transform);
    };
    TransformReader moves(block, apply);
    LightObjects look(block, placed);
    block.read(element.body, declared, fields, look, moves);
    if (block.broken) return std::nullopt;
    const std::string wrong = std::visit([](const auto& l) { return problem(l); }, placed.light);
    if (!wrong.empty())
        block.report(error(Fault::degenerate, element.word_span, wrong).with_help(block.help()));
    const std::string idle = std::visit([](const auto& l) { return effectless(l); }, placed.light);
    if (!idle.empty()) block.report(warning(Fault::no_effect, element.word_span, idle));
    return block.broken ? std::nullopt : std::optional(std::move(placed));
}
