// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/colour_maps.h"
#include "appearance/patterns.h"
#include "appearance/textures.h"
#include "reading/transforms.h"
#include "reading/unbracketed_vector.h"
#include "surface/default_maps.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <utility>

namespace candelabra {

namespace {

constexpr std::string_view pigment_form =
    "{ rgb <r, g, b> }, or pigment { pattern [color_map { [0 rgb ...] [1 rgb ...] }] }";

constexpr std::string_view density_form =
    "{ rgb <r, g, b> }, or density { pattern [color_map { [0 rgb ...] [1 rgb ...] }] }";

/// The words of a block with colours: that of a surface or of a medium.
struct ColouringWords {
    NameId block, map;
    std::string_view block_name, map_name;
};
constexpr ColouringWords pigment_words{"pigment"_word, "pigment_map"_word, "pigment",
                                       "pigment_map"};
constexpr ColouringWords density_words{"density"_word, "density_map"_word, "density",
                                       "density_map"};

const ColouringWords& colouring_words(const OpenBlock& block) {
    return block.name == density_words.block_name || block.name == density_words.map_name
               ? density_words
               : pigment_words;
}

/// The initial state of a block or a map's entry.
Pigment first_colouring(const Binder& binder, const ColouringWords& words) {
    if (words.block != density_words.block) return binder.default_texture->pigment;
    Pigment even;
    even.colour.rgb = Rgb(1);
    return even;
}

/// Whether a pigment has the map that its pattern has if none is given.
bool has_default_map(const PatternedPigment& pigment) {
    const auto* colours = std::get_if<ColourMap>(&pigment.map);
    return colours && choices(pigment.use.pattern) == 0 &&
           *colours == default_map(pigment.use.pattern);
}

/// A pigment under construction.
struct PigmentDraft {
    explicit PigmentDraft(const Pigment& pigment)
        : colour(pigment.colour), uv(pigment.uv), quick(pigment.quick) {
        if (!pigment.pattern) return;
        pattern = PatternDraft(pigment.pattern->use, pigment.transform);
        map = pigment.pattern->map;
        own_map = !has_default_map(*pigment.pattern);
    }
    Pigment made() const {
        if (!pattern.pattern || !map) return {colour, nullptr, {}, false, quick};
        return {colour, make_handle<PatternedPigment>(pattern.use(), *map), pattern.transform, uv,
                quick};
    }
    void clear() { *this = PigmentDraft(Pigment()); }

    Colour colour;
    bool uv = false;
    Handle<Colour> quick;
    PatternDraft pattern;
    std::optional<PatternedPigment::Map> map;
    bool own_map = false;  ///< the map or list is not just the pattern's default map
};

/// Reads a colour, or a pattern with its map or list.
class ColouringReader {
public:
    ColouringReader(OpenBlock& block, PigmentDraft& draft)
        : block_(block),
          words_(colouring_words(block)),
          draft_(draft),
          pattern_(block, draft.pattern, "pigment",
                   [this](const Element& entry) { return take(entry); }) {}

    bool waiting() const { return pattern_.waiting(); }
    bool wants() const { return block_.taken == 0 || pattern_.wants(); }

    bool take(const Element& element) {
        if (pattern_.names_pattern(element)) {
            if (already_coloured(element)) return true;
            take_pattern(element);
            return true;
        }
        if (pattern_.take(element)) return true;
        if (element.kind == Element::Kind::value) return take_colour(element);
        return element.kind == Element::Kind::block && take_block(element);
    }

    void finish() {
        pattern_.finish();
        if (block_.broken || !draft_.pattern.pattern || draft_.map) return;
        if (std::holds_alternative<Average>(*draft_.pattern.pattern))
            block_.report(error(Fault::missing, block_.span,
                                message("`average` needs a `", words_.map_name, '`'))
                              .with_help(message(words_.block_name, " { average ", words_.map_name,
                                                 " { [1 ...] [2 ...] } }")));
        else
            draft_.map = default_map(*draft_.pattern.pattern);
    }

    void add_words(WordList& words) const {
        pattern_.add_words(words);
        words.insert(words.end(), {"color_map", "colour_map", words_.map_name});
    }

private:
    /// A pattern keeps the map of a declared pigment if that one has its own, as in POV-Ray.
    void take_pattern(const Element& element) {
        const std::optional<Pattern>& now = draft_.pattern.pattern;
        const bool averaged = now && std::holds_alternative<Average>(*now);
        auto kept = std::exchange(draft_.map, {});  // the pattern may bring a list of its own
        pattern_.take(element);
        if (!draft_.map && draft_.own_map && now && choices(*now) == 0 &&
            std::holds_alternative<Average>(*now) == averaged)
            draft_.map = std::move(kept);
    }

    bool take_colour(const Element& element) {
        if (!element.value.numbers()) return false;
        if (pattern_.named() && choices(*draft_.pattern.pattern) > 0) {
            list_entry<ColourMap>(element, [&](ColourStop& stop) {
                if (const auto colour = listed_colour(element)) stop.colour = *colour;
            });
            return true;
        }
        if (coloured_ && set_channel(element)) return true;
        if (already_coloured(element)) return true;
        coloured_ = true;
        draft_.clear();
        if (const std::optional<Colour> colour = plain_colour(block_, element))
            draft_.colour = *colour;
        return true;
    }

    /// A colour of a list needs no word. As in POV-Ray, a number stands for all of its components.
    std::optional<Colour> listed_colour(const Element& element) {
        const Numbers& numbers = *element.value.numbers();
        if (numbers.is_colour() || numbers.count == 4) return plain_colour(block_, element);
        Numbers bare = numbers.promoted(5);
        bare.count = 5;
        return bare.to_colour();
    }

    /// Changes a channel of the colour. A directive may continue a colour:
    /// `rgb 1 #if (A) filter 0.5 #end`.
    bool set_channel(const Element& element) {
        const auto& [tree, node] = element.origin;
        const auto* channel = tree && node != no_node ? tree->get_if<node::Channel>(node) : nullptr;
        if (!channel) return false;
        Colour& colour = draft_.colour;
        const std::array<double*, 5> amounts = {&colour.rgb.r, &colour.rgb.g, &colour.rgb.b,
                                                &colour.filter, &colour.transmit};
        constexpr auto words =
            std::array{"red"_word, "green"_word, "blue"_word, "filter"_word, "transmit"_word};
        const auto word = std::ranges::find(words, channel->channel);
        if (word == words.end()) return false;
        const auto component = static_cast<std::size_t>(word - words.begin());
        *amounts[component] = element.value.numbers()->at[component];
        return true;
    }

    bool take_block(const Element& element) {
        const NameId word = element.word;
        if (word == "color_map"_word || word == "colour_map"_word) {
            take_map<ColourMap>(element, read_colour_map);
        } else if (word == words_.map) {
            take_map<PigmentMap>(element, read_pigment_map);
        } else if (word == words_.block && pattern_.named() &&
                   choices(*draft_.pattern.pattern) > 0) {
            const auto read = words_.block == density_words.block ? read_density : read_pigment;
            list_entry<PigmentMap>(element, [&](PigmentStop& stop) {
                block_.broken |= !read(block_.binder, element, stop.pigment);
            });
        } else {
            return false;
        }
        return true;
    }

    template <class Map>
    void take_map(const Element& element, bool (*read)(Binder&, const Element&, Map&)) {
        Map map;
        if (!read(block_.binder, element, map)) block_.broken = true;
        if (block_.broken || !fits(element, map)) return;
        draft_.map = std::move(map);
    }

    bool fits(const Element& element, const ColourMap&) {
        const std::string_view word = block_.spelling(element.word);
        const std::optional<Pattern>& pattern = draft_.pattern.pattern;
        std::string why;
        if (!pattern)
            why = message('`', word, "` needs a pattern before it");
        else if (choices(*pattern) > 0)
            why = message('`', name(), "` takes ", number_word(choices(*pattern)),
                          " colours, not a `", word, "`");
        else if (std::holds_alternative<Average>(*pattern))
            why = message("`average` takes a `", words_.map_name, "`, not a `", word, "`");
        else
            return true;
        block_.report(
            error(Fault::misplaced, element.word_span, std::move(why)).with_help(block_.help()));
        return false;
    }

    bool fits(const Element& element, PigmentMap& map) {
        if (!draft_.pattern.pattern)
            block_.report(error(Fault::misplaced, element.word_span,
                                message('`', words_.map_name, "` needs a pattern before it"))
                              .with_help(block_.help()));
        else
            settle_values(block_, element.word_span, map,
                          std::holds_alternative<Average>(*draft_.pattern.pattern));
        return !block_.broken;
    }

    /// Reads the next entry of a list after checker and similar patterns; missing entries keep
    /// their defaults.
    template <class Map, class Read>
    void list_entry(const Element& element, Read read) {
        if (listed_ == 0) draft_.map = default_list(Map());
        auto* map = std::get_if<Map>(&*draft_.map);
        const bool full = listed_ == static_cast<std::size_t>(choices(*draft_.pattern.pattern));
        if (map && !full) {
            read((*map)[listed_++]);
        } else if (!block_.broken) {
            block_.report(error(
                map ? Fault::wrong_count : Fault::misplaced, element.span,
                map ? message('`', name(), "` takes ", listed_, " colours, but here is one more")
                    : message("the entries of a list are all colours or all ",
                              words_.block == density_words.block ? "densities" : "pigments")));
        }
    }

    PatternedPigment::Map default_list(const ColourMap&) const {
        return default_map(*draft_.pattern.pattern);
    }
    PatternedPigment::Map default_list(const PigmentMap&) const {
        PigmentMap map;
        for (int i = 0; i < choices(*draft_.pattern.pattern); ++i)
            map.push_back({static_cast<double>(i), first_colouring(block_.binder, words_)});
        return map;
    }

    std::string_view name() const {
        return Kinds<Pattern>::infos[draft_.pattern.pattern->index()]->name;
    }

    static std::string_view number_word(int number) {
        constexpr auto words = std::array{"two", "three", "four", "five", "six"};
        return words[static_cast<std::size_t>(number - 2)];
    }

    bool already_coloured(const Element& element) {
        if (!coloured_ && !pattern_.named()) return false;
        if (block_.broken) return true;
        const auto bare = unbracketed_vector(element, block_.binder.evaluator.names());
        block_.report(bare ? *bare
                           : error(Fault::misplaced, element.span,
                                   message("a ", words_.block_name,
                                           " has one colour or one pattern, and this is a second"))
                                 .with_help(block_.help()));
        return true;
    }

    OpenBlock& block_;
    const ColouringWords& words_;
    PigmentDraft& draft_;
    PatternReader pattern_;
    bool coloured_ = false;  ///< whether this block has given the colour
    std::size_t listed_ = 0;
};

/// Reads quick_color and its colour.
class QuickColour {
public:
    explicit QuickColour(OpenBlock& block) : block_(block) {}

    std::optional<Colour> colour;

    bool waiting() const { return waiting_; }
    bool wants() const { return waiting_; }
    bool take(const Element& element) {
        const bool named =
            element.kind == Element::Kind::word &&
            (element.word == "quick_color"_word || element.word == "quick_colour"_word);
        if (waiting_ && element.kind == Element::Kind::value) {
            waiting_ = false;
            colour = plain_colour(block_, element);
            return true;
        }
        if (waiting_) finish();
        if (named) span_ = element.word_span;
        return waiting_ = named;
    }
    void finish() {
        if (std::exchange(waiting_, false))
            block_.report(warning(Fault::missing, span_, "`quick_color` should have a colour")
                              .with_help("quick_color rgb <1, 0.5, 0>"));
    }
    void add_words(WordList& words) const { words.push_back("quick_color"); }

private:
    OpenBlock& block_;
    bool waiting_ = false;
    Span span_;
};

/// Reads the braces of a pigment, or the part of a map's entry behind its number.
template <class Content, class... First>
void read_content(OpenBlock& block, const Content& content, Pigment& pigment, First&... first) {
    QuickColour quick(block);
    read_patterned<PigmentDraft, ColouringReader>(block, content, pigment, "pigments", quick,
                                                  first...);
    if (quick.colour) pigment.quick = make_handle<Colour>(*quick.colour);
}

}  // namespace

bool read_pigment_map(Binder& binder, const Element& element, PigmentMap& map) {
    const ColouringWords& words = element.word == density_words.map ? density_words : pigment_words;
    const auto read_entry = [&](OpenBlock& entry, Body body) {
        EntryNumber number(entry);
        Pigment pigment = first_colouring(binder, words);
        read_content(entry, body, pigment, number);
        if (!entry.broken) map.push_back({*number.value, std::move(pigment)});
    };
    return read_map(binder, element, words.map_name, "{ [0 pattern ...] [1 rgb <r, g, b>] }", map,
                    read_entry);
}

bool read_pigment(Binder& binder, const Element& element, Pigment& pigment) {
    if (colour_alone(element.body))
        if (const auto colour = computed_colour(binder.evaluator, element.body)) {
            pigment = {*colour, nullptr, {}};
            return true;
        }
    OpenBlock block(binder, binder.evaluator.spelling(element.word), element.word_span);
    block.form = pigment_form;
    block.ignored = "no_bump_scale";
    read_content(block, element.body, pigment);
    return !block.broken;
}

bool read_density(Binder& binder, const Element& element, Pigment& density) {
    OpenBlock block(binder, "density", element.word_span);
    block.form = density_form;
    read_content(block, element.body, density);
    return !block.broken;
}

bool read_legacy_pigment(Binder& binder, const ElementList& words, Span span, Pigment& pigment) {
    OpenBlock block(binder, "texture", span);
    block.form = pigment_form;
    read_content(block, words, pigment);
    return !block.broken;
}

}  // namespace candelabra
