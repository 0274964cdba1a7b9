// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/normals.h"

#include "appearance/colour_maps.h"
#include "appearance/patterns.h"
#include "reading/transforms.h"
#include "surface/normal_map.h"
#include "text/message.h"

namespace candelabra {

namespace {

/// A normal under construction.
struct BumpDraft {
    explicit BumpDraft(const Bump& bump) {
        uv = bump.uv;
        if (bump.settings) settings = *bump.settings;
        if (!bump.pattern) return;
        pattern = PatternDraft(bump.pattern->use, bump.transform);
        settings = bump.pattern->settings;
        map = bump.pattern->map;
    }
    Bump made() const {
        if (!pattern.pattern) return {{}, {}, uv, make_handle<BumpSettings>(settings)};
        return {
            make_handle<PatternedBump>(pattern.use(), settings, map), pattern.transform, uv, {}};
    }

    PatternDraft pattern;
    BumpSettings settings;
    PatternedBump::Map map;
    bool uv = false;
};

/// Reads a pattern, its amount, and a map.
class BumpReader {
public:
    BumpReader(OpenBlock& block, BumpDraft& draft)
        : block_(block),
          draft_(draft),
          pattern_(block, draft.pattern, "normal",
                   [this](const Element& entry) { return take(entry); }),
          settings_(block, BumpSettings::vocabulary, &draft.settings) {}

    bool waiting() const { return pattern_.waiting() || settings_.waiting(); }
    bool wants() const { return block_.taken == 0 || pattern_.wants() || settings_.wants(); }

    bool take(const Element& element) {
        if (settings_.waiting() && settings_.take(element)) return true;
        if (pattern_.names_pattern(element)) {
            if (pattern_.named())
                refuse(element, "a normal has one pattern, and this is a second");
            else
                draft_.map = {};
        }
        if (pattern_.take(element)) {
            take_bump_size();
            return true;
        }
        if (settings_.take(element)) return true;
        return element.kind == Element::Kind::block && take_block(element);
    }

    void finish() {
        pattern_.finish();
        settings_.finish();
        const bool average =
            draft_.pattern.pattern && std::holds_alternative<Average>(*draft_.pattern.pattern);
        if (average && !block_.broken && !std::holds_alternative<NormalMap>(draft_.map))
            block_.report(error(Fault::missing, block_.span, "`average` needs a `normal_map`")
                              .with_help("normal { average normal_map { [1 ...] [2 ...] } }"));
    }

    void add_words(WordList& words) const {
        pattern_.add_words(words);
        settings_.add_words(words);
        words.insert(words.end(), {"slope_map", "normal_map"});
    }

private:
    bool take_block(const Element& element) {
        if (element.word == "slope_map"_word)
            take_map<SlopeMap>(element, read_slope_map);
        else if (element.word == "normal_map"_word)
            take_map<NormalMap>(element, read_normal_map);
        else if (element.word == "normal"_word && pattern_.named() &&
                 choices(*draft_.pattern.pattern) > 0)
            take_list_entry(element);
        else
            return false;
        return true;
    }

    /// Moves the bump_size in the braces of a bump_map to the whole normal.
    void take_bump_size() {
        auto& pattern = draft_.pattern.pattern;
        auto* map = pattern ? std::get_if<BumpMap>(&*pattern) : nullptr;
        if (!map || !map->bump_size) return;
        draft_.settings.bump_size = *map->bump_size;
        map->bump_size.reset();
    }

    template <class Map>
    void take_map(const Element& element, bool (*read)(Binder&, const Element&, Map&)) {
        Map map;
        if (!read(block_.binder, element, map)) block_.broken = true;
        if (block_.broken) return;
        if (!draft_.pattern.pattern)
            return refuse(element, message('`', block_.spelling(element.word),
                                           "` needs a pattern before it"));
        settle_values(block_, element.word_span, map,
                      std::holds_alternative<Average>(*draft_.pattern.pattern));
        draft_.map = std::move(map);
    }

    /// Reads the next normal after checker and similar patterns; missing ones are the default
    /// texture's.
    void take_list_entry(const Element& element) {
        const auto count = static_cast<std::size_t>(choices(*draft_.pattern.pattern));
        if (listed_ == count)
            return refuse(element,
                          message("this pattern takes ", count, " normals, but here is one more"));
        if (listed_ == 0) {
            NormalMap map;
            for (std::size_t i = 0; i < count; ++i)
                map.push_back({static_cast<double>(i), block_.binder.default_texture->normal});
            draft_.map = std::move(map);
        }
        auto& map = std::get<NormalMap>(draft_.map);
        block_.broken |= !read_normal(block_.binder, element, map[listed_++].bump);
    }

    void refuse(const Element& element, std::string why) {
        if (!block_.broken)
            block_.report(error(Fault::misplaced, element.word_span, std::move(why))
                              .with_help(block_.help()));
    }

    OpenBlock& block_;
    BumpDraft& draft_;
    PatternReader pattern_;
    ItemReader settings_;
    std::size_t listed_ = 0;
};

/// Reads the braces of a normal, or the part of a map's entry behind its number.
template <class Content, class... First>
void read_content(OpenBlock& block, const Content& content, Bump& bump, First&... first) {
    read_patterned<BumpDraft, BumpReader>(block, content, bump, "normals", first...);
}

/// Reads [value <height, slope>].
void read_slope_entry(OpenBlock& entry, Body body, SlopeMap& map) {
    struct Point : SimpleReader {
        explicit Point(OpenBlock& block) : block(block) {}
        bool wants() const { return !pair; }
        bool take(const Element& element) {
            if (pair || element.kind != Element::Kind::value) return false;
            pair = Vec2(0);
            const auto value = converted(block, element, FieldType::vector2,
                                         {[] { return std::string("an entry of `slope_map`"); },
                                          [&] { return block.help(); }});
            if (value) pair = std::get<Vec2>(*value);
            return true;
        }
        void finish() {
            if (!pair && !block.broken)
                block.report(error(Fault::missing, block.span,
                                   "an entry of `slope_map` needs a height and a slope")
                                 .with_help(block.help()));
        }
        OpenBlock& block;
        std::optional<Vec2> pair;
    };
    EntryNumber number(entry);
    Point point(entry);
    entry.read(body, number, point);
    if (!entry.broken) map.push_back({*number.value, point.pair->x, point.pair->y});
}

}  // namespace

bool read_normal(Binder& binder, const Element& element, Bump& bump) {
    OpenBlock block(binder, "normal", element.word_span);
    block.item = &BumpSettings::vocabulary;
    block.form = "{ pattern [amount] [slope_map { ... }] }";
    read_content(block, element.body, bump);
    return !block.broken;
}

bool read_legacy_normal(Binder& binder, const ElementList& words, Span span, Bump& bump) {
    OpenBlock block(binder, "texture", span);
    block.item = &BumpSettings::vocabulary;
    read_content(block, words, bump);
    return !block.broken;
}

void keep_heights(Bump& bump) {
    BumpDraft draft(bump);
    draft.settings.no_bump_scale = true;
    Bump kept = draft.made();
    kept.frame = bump.frame;
    bump = std::move(kept);
}

bool read_normal_map(Binder& binder, const Element& element, NormalMap& map) {
    const auto read_entry = [&](OpenBlock& entry, Body body) {
        EntryNumber number(entry);
        Bump bump = binder.default_texture->normal;
        read_content(entry, body, bump, number);
        if (!entry.broken) map.push_back({*number.value, std::move(bump)});
    };
    return read_map(binder, element, "normal_map",
                    "{ [0 pattern amount ...] [1 pattern amount ...] }", map, read_entry);
}

bool read_slope_map(Binder& binder, const Element& element, SlopeMap& map) {
    const auto read_entry = [&](OpenBlock& entry, Body body) {
        read_slope_entry(entry, body, map);
    };
    return read_map(binder, element, "slope_map", "{ [0 <height, slope>] [1 <height, slope>] }",
                    map, read_entry);
}

}  // namespace candelabra
