// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/textures.h"

#include "appearance/colour_maps.h"
#include "appearance/legacy_textures.h"
#include "appearance/normals.h"
#include "appearance/patterns.h"
#include "appearance/pictures.h"
#include "reading/transforms.h"
#include "surface/legacy_layers.h"
#include "surface/texture_map.h"
#include "text/message.h"

namespace candelabra {

namespace {

/// Reads pigment { }, normal { } and finish { } in a texture, or declared ones.
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

/// Reads `no_bump_scale`, which may stand anywhere in a texture.
class BumpScaleReader : public SimpleReader {
public:
    explicit BumpScaleReader(OpenBlock& block) : block_(block) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::word || element.word != "no_bump_scale"_word)
            return false;
        word_ = element.word_span;
        return true;
    }
    void add_words(WordList& words) const { words.push_back("no_bump_scale"); }

    /// Keeps the heights of the uppermost layer's normal when it is scaled.
    void apply(TextureDraft& draft, bool patterned) const {
        if (!word_) return;
        if (patterned)
            return block_.report(warning(Fault::no_effect, *word_,
                                         "`no_bump_scale` has no effect in a texture that chooses "
                                         "by a pattern")
                                     .with_help("it belongs in the normals that are chosen"));
        keep_heights(draft.edit().normal);
    }

private:
    OpenBlock& block_;
    std::optional<Span> word_;
};

/// Reads tiles { texture { A } tile2 texture { B } }.
class TilesReader : public SimpleReader {
public:
    explicit TilesReader(OpenBlock& block) : block_(block) {}

    bool take(const Element& element) {
        if (element.kind == Element::Kind::word && element.word == "tile2"_word) return true;
        if (element.kind != Element::Kind::block || element.word != "texture"_word) return false;
        if (map.size() == 2) return false;
        const Handle<Texture> texture = read_whole_texture(block_.binder, element);
        block_.broken |= !texture;
        // The first texture fills the odd cubes, so it comes second in the map.
        map.insert(map.begin(), {0, texture});
        return true;
    }

    void finish() {
        if (!block_.broken && map.size() < 2)
            block_.report(error(Fault::wrong_count, block_.span, "`tiles` needs two textures")
                              .with_help(block_.help()));
        if (map.size() == 2) map[1].value = 1;
    }

    TextureMap map;

private:
    OpenBlock& block_;
};

/// Reads the textures of a material_map, numbered from 0.
class TextureBlocksReader : public SimpleReader {
public:
    explicit TextureBlocksReader(OpenBlock& block) : block_(block) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || element.word != "texture"_word) return false;
        const Handle<Texture> texture = read_whole_texture(block_.binder, element);
        block_.broken |= !texture;
        map.push_back({static_cast<double>(map.size()), texture});
        return true;
    }
    void finish() {
        if (map.empty() && !block_.broken)
            block_.report(error(Fault::missing, block_.span, "`material_map` needs textures")
                              .with_help(block_.help()));
    }
    void add_words(WordList& words) const { words.push_back("texture"); }

    TextureMap map;

private:
    OpenBlock& block_;
};

/// Reads a pattern and the textures that it chooses from.
class ChoiceReader {
public:
    explicit ChoiceReader(OpenBlock& block)
        : block_(block),
          pattern_(block, draft_, "texture", [this](const Element& entry) { return take(entry); }) {
    }

    bool waiting() const { return pattern_.named() && pattern_.waiting(); }
    bool wants() const { return pattern_.named() && pattern_.wants(); }

    bool take(const Element& element) {
        if (patterns_ &&
            (pattern_.names_pattern(element) || pattern_.named() || is_function(element)))
            if (pattern_.take(element)) return true;
        return element.kind == Element::Kind::block && take_block(element);
    }

    void finish() {
        pattern_.finish();
        if (!pattern_.named() || block_.broken || !map_.empty()) return;
        block_.report(error(Fault::missing, block_.span,
                            "a texture with a pattern needs a `texture_map`, or a list of textures")
                          .with_help("texture { gradient y texture_map { [0 ...] [1 ...] } }"));
    }

    void add_words(WordList& words) const {
        pattern_.add_words(words);
        words.insert(words.end(), {"texture_map", "tiles", "material_map"});
    }

    /// Whether there is a pattern; otherwise the texture is a plain one.
    bool named() const { return pattern_.named() || named_; }
    void move(const Transform& transform) { draft_.move(transform); }

    /// Precondition: named(), and the block is not broken.
    Handle<PatternedTexture> made() const {
        return make_handle<PatternedTexture>(draft_.use(), draft_.transform, map_);
    }

private:
    static bool is_function(const Element& element) {
        return element.kind == Element::Kind::value && element.value.handle<Formula>();
    }

    bool take_block(const Element& element) {
        if (element.word == "texture_map"_word)
            take_map(element);
        else if (element.word == "tiles"_word)
            take_tiles(element);
        else if (element.word == "material_map"_word)
            take_material_map(element);
        else if (element.word == "texture"_word && pattern_.named() && choices(*draft_.pattern) > 0)
            take_list_entry(element);
        else
            return false;
        return true;
    }

    void take_map(const Element& element) {
        TextureMap map;
        block_.broken |= !read_texture_map(block_.binder, element, map);
        if (block_.broken) return;
        if (!pattern_.named())
            block_.report(error(Fault::misplaced, element.word_span,
                                "`texture_map` needs a pattern before it")
                              .with_help(block_.help()));
        else
            settle_values(block_, element.word_span, map,
                          std::holds_alternative<Average>(*draft_.pattern));
        map_ = std::move(map);
    }

    void take_tiles(const Element& element) {
        OpenBlock inner(block_.binder, "tiles", element.word_span);
        inner.form = "{ texture { ... } tile2 texture { ... } }";
        TilesReader reader(inner);
        inner.read(element.body, reader);
        block_.broken |= inner.broken;
        named_ = true;
        draft_.pattern = Checker{};
        name_pattern(*draft_.pattern, draft_.modifiers, draft_.wave);
        map_ = std::move(reader.map);
    }

    /// Reads a picture and the textures that its colours select.
    void take_material_map(const Element& element) {
        OpenBlock inner(block_.binder, "material_map", element.word_span);
        inner.form = "{ \"picture.png\" texture { ... } texture { ... } ... }";
        TextureBlocksReader textures(inner);
        Pattern pattern = MaterialMap{};
        read_picture(inner, element.body, pattern, textures);
        block_.broken |= inner.broken;
        std::get<MaterialMap>(pattern).textures = static_cast<int>(textures.map.size());
        named_ = true;
        draft_.pattern = std::move(pattern);
        name_pattern(*draft_.pattern, draft_.modifiers, draft_.wave);
        map_ = std::move(textures.map);
    }

    /// Reads the next texture after checker and similar patterns; missing ones are the default
    /// texture.
    void take_list_entry(const Element& element) {
        const auto count = static_cast<std::size_t>(choices(*draft_.pattern));
        if (listed_ == count) {
            block_.report(
                error(Fault::wrong_count, element.word_span,
                      message("this pattern takes ", count, " textures, but here is one more")));
            return;
        }
        if (listed_ == 0) {
            map_.clear();
            for (std::size_t i = 0; i < count; ++i)
                map_.push_back({static_cast<double>(i), block_.binder.default_texture});
        }
        Handle<Texture> texture = read_whole_texture(block_.binder, element);
        block_.broken |= !texture;
        map_[listed_++].texture = std::move(texture);
    }

    OpenBlock& block_;
    PatternDraft draft_;
    PatternReader pattern_;
    TextureMap map_;
    std::size_t listed_ = 0;
    bool named_ = false;  ///< tiles or material_map has given the pattern
    /// Whether a pattern chooses textures here instead of colours.
    bool patterns_ = !LegacyTextureReader::known_to(block_.binder);
};

/// Reads the braces of a texture, or the part of a map's entry behind its number.
template <class... First>
void read_content(OpenBlock& block, Body body, TextureDraft& draft, First&... first) {
    auto declared =
        named<Texture>(block, [&](const Handle<Texture>& texture) { draft.replace(texture); });
    PartReader parts(block, draft);
    ChoiceReader choice(block);
    LegacyTextureReader old(block, draft);
    const auto apply = [&](const Transform& transform) {
        if (choice.named())
            choice.move(transform);
        else if (!old.move(transform))
            draft.move(transform);
    };
    TransformReader moves(block, apply);
    UvReader uv(block);
    BumpScaleReader heights(block);
    block.read(body, first..., declared, uv, choice, parts, moves, old, heights);
    if (block.broken) return;
    heights.apply(draft, choice.named());
    if (choice.named()) draft.edit().choice = choice.made();
    if (uv.given) draft.edit() = uv_mapped_with_frame(draft.now());
    if (nesting(draft.now()).too_deep())
        block.report(error(Fault::recursion_limit, block.span,
                           "too many textures are nested here: each level can double the work"));
}

/// Bounds the recursion through layers; far more than can be visible.
constexpr int max_layers = 1000;

int layers(const Texture& texture) {
    int count = 0;
    for (const Texture* layer = &texture; layer; layer = layer->below.get()) ++count;
    return count;
}

/// Puts `below` under the lowest layer of `above`.
Texture stacked(Texture above, const Handle<Texture>& below) {
    above.below = above.below ? make_handle<Texture>(stacked(*above.below, below)) : below;
    return above;
}

}  // namespace

bool read_texture(Binder& binder, const Element& element, TextureDraft& draft) {
    OpenBlock block(binder, "texture", element.word_span);
    block.form = "{ [Name] pigment { ... } normal { ... } finish { ... } [transformations] }";
    read_content(block, element.body, draft);
    return !block.broken;
}

Handle<Texture> read_whole_texture(Binder& binder, const Element& element) {
    TextureDraft draft(binder.default_texture);
    return read_texture(binder, element, draft) ? draft.shared(binder.textures) : nullptr;
}

bool read_texture_map(Binder& binder, const Element& element, TextureMap& map) {
    const auto read_entry = [&](OpenBlock& entry, Body body) {
        EntryNumber number(entry);
        TextureDraft draft(binder.default_texture);
        read_content(entry, body, draft, number);
        if (!entry.broken) map.push_back({*number.value, draft.shared(binder.textures)});
    };
    return read_map(binder, element, "texture_map",
                    "{ [0 Texture] [1 pigment { ... } finish { ... }] }", map, read_entry);
}

Handle<Texture> layered(OpenBlock& block, Span span, const Handle<Texture>& below,
                        Handle<Texture> above) {
    if (above->choice) return above;  // it hides the layers below
    constexpr double last_of_legacy_layers = 3.1;
    if (block.binder.evaluator.version() <= last_of_legacy_layers)
        above = make_handle<Texture>(with_filter_as_transmit(*above));
    if (!transparent(*above)) {
        // Reflections of the layers below remain visible.
        const Reflection& lower = below->finish.reflection;
        if (!below->choice && !below->below && lower.least == Rgb(0) && lower.greatest == Rgb(0))
            return above;
    }
    if (below->choice) {
        block.report(error(Fault::misplaced, span,
                           "a texture that chooses by a pattern cannot be seen through another")
                         .with_help("put both textures into its `texture_map`"));
        return above;
    }
    if (layers(*above) + layers(*below) > max_layers) {
        block.report(error(Fault::recursion_limit, span,
                           message("a texture cannot have more than ", max_layers, " layers"))
                         .with_help("give it fewer textures that can be seen through"));
        return above;
    }
    return make_handle<Texture>(stacked(*above, below));
}

Handle<Texture> read_layers(Binder& binder, std::span<const Element> elements) {
    OpenBlock block(binder, "texture", elements.front().word_span);
    TextureDraft result(binder.default_texture);
    for (const Element& element : elements) {
        TextureDraft draft(binder.default_texture);
        if (!read_texture(binder, element, draft)) return nullptr;
        Handle<Texture> made = draft.shared(binder.textures);
        if (&element == &elements.front())
            result.replace(std::move(made));
        else
            result.replace(layered(block, element.word_span, result.handle(), std::move(made)));
    }
    return block.broken ? nullptr : result.shared(binder.textures);
}

}  // namespace candelabra
