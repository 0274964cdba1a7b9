// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/textures.h"
#include "evaluate/transforms.h"
#include "text/message.h"

namespace {

constexpr std::string_view pigment_form =
    "{ rgb <r, g, b> }, or pigment { pattern [color_map { [0 rgb ...] [1 rgb ...] }] }";

/// The values of an entry of a colour map: [v colour], or [v1, v2 colour colour].
class EntryReader : public SimpleReader {
public:
    EntryReader(OpenBlock& block, ColourMap& map) : block_(block), map_(map) {}

    bool wants() const { return true; }

    bool take(const Element& element) {
        if (element.kind != Element::Kind::value) return false;
        if (element.value.broken())
            block_.broken = true;
        else if (colours_ == 0 && values_ < 2 && element.value.numbers() &&
                 element.value.numbers()->is_scalar())
            at_[values_++] = element.value.numbers()->at[0];
        else
            take_colour(element);
        return true;
    }

    void finish() {
        if (block_.broken || (values_ > 0 && colours_ == values_)) return;
        block_.report(error(Fault::missing, block_.span,
                            values_ == 0 ? "an entry of `color_map` begins with a number"
                                         : "an entry of `color_map` needs a colour")
                          .with_help(block_.help()));
    }

private:
    void take_colour(const Element& element) {
        if (colours_ >= std::max(values_, 1)) {
            if (!block_.broken)
                block_.report(error(Fault::wrong_count, element.span,
                                    "an entry of `color_map` has one colour for each number")
                                  .with_help(block_.help()));
            return;
        }
        const std::optional<Colour> colour = plain_colour(block_, element);
        if (colour) map_.push_back({at_[static_cast<std::size_t>(colours_)], *colour});
        ++colours_;
    }

    OpenBlock& block_;
    ColourMap& map_;
    std::array<double, 2> at_{};
    int values_ = 0;
    int colours_ = 0;
};

class MapReader : public SimpleReader {
public:
    MapReader(OpenBlock& block, ColourMap& map) : block_(block), map_(map) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::entry) return false;
        OpenBlock entry(block_.binder, block_.name, element.span);
        entry.form = block_.form;
        EntryReader values(entry, map_);
        entry.read(element.body, values);
        block_.broken |= entry.broken;
        return true;
    }

private:
    OpenBlock& block_;
    ColourMap& map_;
};

/// A colour or a pattern, with what the pattern needs.
class ColouringReader {
public:
    ColouringReader(OpenBlock& block, Pigment& pigment)
        : block_(block), pigment_(pigment), fields_(block, Checker::vocabulary, nullptr) {}

    bool waiting() const { return chosen_ && fields_.waiting(); }
    bool wants() const { return block_.taken == 0 || (chosen_ && fields_.wants()); }

    bool take(const Element& element) {
        switch (element.kind) {
            case Element::Kind::value:
                return take_value(element);
            case Element::Kind::word:
                return take_word(element);
            case Element::Kind::block:
                return take_block(element);
            case Element::Kind::list:
            case Element::Kind::entry:
            case Element::Kind::braces:
                break;
        }
        return false;
    }

    void finish() {
        if (chosen_) fields_.finish();
        if (block_.broken || !pigment_.pattern) return;
        if (pigment_.map.empty()) pigment_.map = default_map(*pigment_.pattern);
    }

    void add_words(WordList& words) const {
        for (const ItemInfo* pattern : Kinds<Pattern>::infos) words.push_back(pattern->name);
        words.insert(words.end(), {"color_map", "colour_map"});
    }

private:
    bool take_value(const Element& element) {
        if (chosen_ && fields_.take(element)) return true;
        if (!element.value.numbers()) return false;
        if (chosen_ && std::holds_alternative<Checker>(*pigment_.pattern))
            return take_list_colour(element);
        if (already_coloured(element.span)) return true;
        coloured_ = true;
        pigment_.pattern.reset();
        pigment_.map.clear();
        if (const std::optional<Colour> colour = plain_colour(block_, element))
            pigment_.colour = *colour;
        return true;
    }

    bool take_word(const Element& element) {
        if (chosen_ && fields_.take(element)) return true;
        const std::size_t kind = Kinds<Pattern>::find(element.word);
        if (kind == Kinds<Pattern>::count) return false;
        if (already_coloured(element.span)) return true;
        if (!pigment_.pattern || pigment_.pattern->index() != kind) pigment_.map.clear();
        pigment_.pattern = Kinds<Pattern>::make(kind);
        fields_.rebind(*Kinds<Pattern>::infos[kind], Kinds<Pattern>::address(*pigment_.pattern));
        chosen_ = true;
        return true;
    }

    bool take_block(const Element& element) {
        if (chosen_ && fields_.take(element)) return true;
        if (element.word != "color_map"_word && element.word != "colour_map"_word) return false;
        ColourMap map;
        if (!read_colour_map(block_.binder, element, map)) {
            block_.broken = true;
        } else if (block_.broken) {
            return true;
        } else if (!pigment_.pattern || std::holds_alternative<Checker>(*pigment_.pattern)) {
            block_.report(error(Fault::misplaced, element.word_span,
                                pigment_.pattern ? "`checker` takes two colours, not a `color_map`"
                                                 : "`color_map` needs a pattern before it")
                              .with_help(block_.help()));
        } else {
            pigment_.map = std::move(map);
        }
        return true;
    }

    bool take_list_colour(const Element& element) {
        if (listed_ == 0) pigment_.map = default_map(*pigment_.pattern);
        if (listed_ == static_cast<int>(pigment_.map.size())) {
            if (!block_.broken)
                block_.report(
                    error(Fault::wrong_count, element.span,
                          message("`checker` takes ", listed_, " colours, but here is one more")));
            return true;
        }
        if (const std::optional<Colour> colour = plain_colour(block_, element))
            pigment_.map[static_cast<std::size_t>(listed_)].colour = *colour;
        ++listed_;
        return true;
    }

    bool already_coloured(Span span) {
        if (!coloured_ && !chosen_) return false;
        if (!block_.broken)
            block_.report(error(Fault::misplaced, span,
                                "a pigment has one colour or one pattern, and this is a second")
                              .with_help(block_.help()));
        return true;
    }

    OpenBlock& block_;
    Pigment& pigment_;
    ItemReader fields_;
    bool chosen_ = false;    ///< this block has named the pattern
    bool coloured_ = false;  ///< this block has given the colour
    int listed_ = 0;
};

}  // namespace

bool read_colour_map(Binder& binder, const Element& element, ColourMap& map) {
    OpenBlock block(binder, "color_map", element.word_span);
    block.form = "{ [0 rgb <r, g, b>] [1 rgb <r, g, b>] }";
    auto declared = named<std::vector<ColourStop>>(
        block, [&](const Handle<ColourMap>& other) { map = *other; });
    MapReader entries(block, map);
    block.read(element.body, declared, entries);
    if (!block.broken && map.empty())
        block.report(error(Fault::missing, element.word_span, "`color_map` has no entries")
                         .with_help(block.help()));
    return !block.broken;
}

bool read_pigment(Binder& binder, const Element& element, Pigment& pigment) {
    OpenBlock block(binder, "pigment", element.word_span);
    block.form = pigment_form;
    block.effectless = "quick_color quick_colour";
    auto declared = named<Pigment>(block, [&](const Handle<Pigment>& other) { pigment = *other; });
    ColouringReader colouring(block, pigment);
    const auto apply = [&](const Transform& transform) {
        pigment.transform = pigment.transform.then(transform);
    };
    TransformReader moves(block, apply);
    block.read(element.body, declared, colouring, moves);
    return !block.broken;
}
