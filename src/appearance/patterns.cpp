// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/patterns.h"

#include "appearance/pictures.h"
#include "appearance/textures.h"
#include "csg/assemble.h"
#include "reading/transforms.h"
#include "scene/pattern_object.h"
#include "surface/normal_map.h"
#include "surface/pigment_map.h"
#include "text/message.h"
#include "vocabulary/manual.h"

namespace candelabra {

namespace {

using Patterns = Kinds<Pattern>;
using Waveforms = Kinds<Waveform>;
using Warps = Kinds<Warp>;

constexpr std::string_view warp_form =
    "{ turbulence v }, or one of: repeat, black_hole, cylindrical, spherical, toroidal, planar, "
    "cubic";

/// Reads the kind of a warp, which is the first word, and its values.
class WarpReader {
public:
    WarpReader(OpenBlock& block, Warp& warp)
        : block_(block), warp_(warp), fields_(block, TurbulenceWarp::vocabulary, nullptr) {}

    bool waiting() const { return named_ && fields_.waiting(); }
    bool wants() const { return !named_ || fields_.wants(); }

    bool take(const Element& element) {
        if (named_) return fields_.take(element);
        if (element.kind != Element::Kind::word) return false;
        const std::size_t kind = Warps::find(element.word);
        if (kind == Warps::count) return false;
        warp_ = Warps::make(kind);
        fields_.rebind(*Warps::infos[kind], Warps::address(warp_));
        block_.form = {};
        block_.item = Warps::infos[kind];
        named_ = true;
        return true;
    }

    void finish() {
        if (named_) fields_.finish();
        if (block_.broken) return;
        const auto* repeat = std::get_if<RepeatWarp>(&warp_);
        const auto axes =
            repeat ? (repeat->width.x != 0) + (repeat->width.y != 0) + (repeat->width.z != 0) : 1;
        if (!named_)
            block_.report(error(Fault::missing, block_.span, "`warp` needs the name of a kind")
                              .with_help(block_.help()));
        else if (axes != 1)
            block_.report(error(Fault::out_of_range, block_.span,
                                "`width` of `repeat` must lie along one axis, and not be 0")
                              .with_help("warp { repeat 2*x }"));
    }

    void add_words(WordList& words) const {
        if (named_) return fields_.add_words(words);
        for (const ItemInfo* info : Warps::infos) words.push_back(info->name);
    }

private:
    OpenBlock& block_;
    Warp& warp_;
    ItemReader fields_;
    bool named_ = false;
};

void load_density(OpenBlock& block, Span span, DensityFile& file) {
    if (file.df3.empty()) {
        block.report(error(Fault::missing, span, "`density_file` needs the name of a file")
                         .with_help("density_file df3 \"cloud.df3\""));
        return;
    }
    const std::optional<std::string> content = block.binder.evaluator.load_data(file.df3, span);
    std::optional<DensityGrid> grid =
        content ? read_density_grid(*content) : std::optional<DensityGrid>();
    if (content && !grid)
        block.report(
            error(Fault::file_access, span, message("`", file.df3, "` is no file of format df3"))
                .with_help("it has three sizes of two bytes, then all values of 1, 2 or 4 bytes "
                           "each, high byte first"));
    block.broken |= !grid;
    if (grid) file.grid = make_handle<DensityGrid>(std::move(*grid));
}

/// Reports numbers of a pavement that does not exist.
void check_pavement(OpenBlock& block, Span span, const Pavement& pavement) {
    const int sides = pavement.number_of_sides, tiles = pavement.number_of_tiles;
    const std::span<const int> patterns = pavement_patterns(sides);
    const int most_tiles = static_cast<int>(patterns.size());
    const bool tiles_exist = tiles >= 1 && tiles <= most_tiles;
    const int most = tiles_exist ? patterns[static_cast<std::size_t>(tiles - 1)] : 0;
    std::string fault;
    if (patterns.empty())
        fault = message("`number_of_sides` of `pavement` must be 3, 4 or 6, but it is ", sides);
    else if (!tiles_exist)
        fault = message("`number_of_tiles` of `pavement` must be from 1 to ", most_tiles,
                        " for `number_of_sides ", sides, "`, but it is ", tiles);
    else if (pavement.pattern < 1 || pavement.pattern > most)
        fault = message("`pattern` of `pavement` must be ", most == 1 ? "" : "from 1 to ", most,
                        " for `number_of_sides ", sides, " number_of_tiles ", tiles,
                        "`, but it is ", pavement.pattern);
    if (!fault.empty())
        block.report(error(Fault::out_of_range, span, std::move(fault))
                         .with_help("pavement number_of_sides 4 number_of_tiles 3 pattern 2"));
}

std::string_view pattern_name(const Pattern& pattern) {
    return Patterns::infos[pattern.index()]->name;
}

}  // namespace

ObjectPattern object_pattern(const Object& object) {
    ShapeStore shapes;
    auto data = std::make_shared<PatternObject>(
        PatternObject{composite_of(object, shapes), make_handle<Object>(object)});
    const auto inside = [](const void* data, const Vec3& point, const PatternScene&) {
        return static_cast<const PatternObject*>(data)->solid.inside(point) ? 1.0 : 0.0;
    };
    return {{std::move(data), inside}};
}

namespace {

/// Reads an object and passes the remaining elements on.
class InsideReader : public SimpleReader {
public:
    InsideReader(OpenBlock& block, FunctionRef<void(const Object&)> found,
                 FunctionRef<bool(const Element&)> rest)
        : block_(block), found_(found), rest_(rest) {}

    bool wants() const { return !done_; }
    bool take(const Element& element) {
        if (done_) return rest_(element);
        ObjectHandle object;
        if (element.kind == Element::Kind::value)
            object = element.value.handle<Object>();
        else if (block_.makes_object(element))
            object = block_.binder.blocks.read_object(block_.binder, element);
        else
            return false;
        block_.broken |= !object;
        if (object) found_(*object);
        return done_ = true;
    }
    void finish() {
        if (!done_ && !block_.broken)
            block_.report(error(Fault::missing, block_.span, "`object` needs an object")
                              .with_help("pigment { object { Thing rgb 1, rgb <1, 0, 0> } }"));
    }
    void add_words(WordList& words) const {
        for (const ItemInfo* shape : Kinds<Shape>::infos) words.push_back(shape->name);
    }

private:
    OpenBlock& block_;
    FunctionRef<void(const Object&)> found_;
    FunctionRef<bool(const Element&)> rest_;
    bool done_ = false;
};

}  // namespace

PatternDraft::PatternDraft(const PatternUse& use, const Transform& outside)
    : pattern(use.pattern),
      modifiers(use.modifiers),
      wave(use.wave),
      steps(use.steps),
      transform(outside) {}

void PatternDraft::add(Warp warp) {
    if (!(transform == Transform())) steps.emplace_back(std::exchange(transform, {}));
    if (auto* hole = std::get_if<BlackHole>(&warp)) fit_blocks(*hole);
    steps.emplace_back(std::move(warp));
}

PatternReader::PatternReader(OpenBlock& block, PatternDraft& draft, std::string_view home,
                             std::function<bool(const Element&)> list_entry)
    : block_(block),
      draft_(draft),
      home_(home),
      fields_(block, Bozo::vocabulary, nullptr),
      modifiers_(block, PatternModifiers::vocabulary, &draft.modifiers),
      wave_(block, RampWave::vocabulary, nullptr),
      list_entry_(std::move(list_entry)) {}

bool PatternReader::waiting() const {
    return fields_.waiting() || modifiers_.waiting() || wave_.waiting();
}

void PatternReader::add_words(WordList& words) const {
    for (const ItemInfo* info : Patterns::infos) words.push_back(info->name);
    for (const ItemInfo* info : Waveforms::infos) words.push_back(info->name);
    fields_.add_words(words);
    modifiers_.add_words(words);
    words.push_back("warp");
}

bool PatternReader::names_pattern(const Element& element) const {
    const bool named = element.kind == Element::Kind::word || element.kind == Element::Kind::block;
    if (!named || fields_.knows(element.word)) return false;
    return Patterns::find(element.word) != Patterns::count;
}

bool PatternReader::take(const Element& element) {
    switch (element.kind) {
        case Element::Kind::value:
            return take_value(element);
        case Element::Kind::word:
            return take_word(element);
        case Element::Kind::block:
            return take_block(element);
        case Element::Kind::list:
            return last_ && last_->take(element);
        case Element::Kind::entry:
        case Element::Kind::braces:
        case Element::Kind::joined:
        case Element::Kind::omitted:
            break;
    }
    return false;
}

bool PatternReader::take_value(const Element& element) {
    if (Handle<Formula> formula = element.value.handle<Formula>()) {
        take_function(std::move(formula), element.span);
        return true;
    }
    // A declared name may also be a word of the pattern.
    if (!(last_ && last_->take(element)) && !(last_ != &fields_ && fields_.take(element)))
        return false;
    // Only in braces does a slope have a range: here a number has another meaning.
    if (last_ == &fields_ && std::holds_alternative<Slope>(*draft_.pattern)) fields_.complete();
    return true;
}

void PatternReader::take_function(Handle<Formula> formula, Span span) {
    if (formula->parameters() != 3 || formula->results() != 1)
        block_.report(error(Fault::wrong_count, span,
                            "a function that is a pattern makes one number of x, y and z")
                          .with_help("function { f_noise3d(x, y, z) }"));
    name(Patterns::find("function"));
    std::get<FunctionPattern>(*draft_.pattern).formula = std::move(formula);
    name_span_ = span;
}

bool PatternReader::take_word(const Element& element) {
    // All readers see the word, so that one that waits for a value can report that it is missing.
    for (ItemReader* reader : {&fields_, &modifiers_, &wave_})
        if (reader->take(element)) {
            last_ = reader;
            return true;
        }
    if (const std::size_t kind = Waveforms::find(element.word); kind != Waveforms::count) {
        wave_.finish();
        draft_.wave = Waveforms::make(kind);
        wave_.rebind(*Waveforms::infos[kind], Waveforms::address(draft_.wave));
        last_ = &wave_;
        return true;
    }
    const std::size_t kind = Patterns::find(element.word);
    if (kind == Patterns::count) return false;
    name(kind, element.span);
    name_span_ = element.span;
    return true;
}

void PatternReader::name(std::size_t kind, Span word) {
    draft_.pattern = Patterns::make(kind);
    fields_.rebind(*Patterns::infos[kind], Patterns::address(*draft_.pattern), word);
    name_pattern(*draft_.pattern, draft_.modifiers, draft_.wave);
    last_ = &fields_;
    named_ = true;
}

bool PatternReader::take_block(const Element& element) {
    for (ItemReader* reader : {&fields_, &modifiers_, &wave_})
        if (reader->take(element)) return true;
    if (element.word == "warp"_word) {
        read_warp(element);
        return true;
    }
    return read_in_braces(element);
}

/// Reads patterns whose values stand in braces.
bool PatternReader::read_in_braces(const Element& element) {
    const std::size_t kind = Patterns::find(element.word);
    if (kind == Patterns::count) return false;
    if (element.word == "object"_word) return read_object_pattern(element);
    Pattern made = Patterns::make(kind);
    OpenBlock inner(block_.binder, Patterns::infos[kind]->name, element.word_span);
    if (auto* slope = std::get_if<Slope>(&made)) {
        inner.item = Patterns::infos[kind];
        ItemReader fields(inner, *inner.item, slope);
        inner.read(element.body, fields);
    } else if (std::holds_alternative<PigmentGrey>(made)) {
        Pigment pigment = block_.binder.default_texture->pigment;
        inner.broken = !read_pigment(block_.binder, element, pigment);
        made = grey_of(std::move(pigment));
    } else if (picture_of(made) && !std::holds_alternative<MaterialMap>(made)) {
        read_picture(inner, element.body, made);
    } else {
        return false;
    }
    block_.broken |= inner.broken;
    take_made(std::move(made), element.word_span);
    return true;
}

void PatternReader::take_made(Pattern made, Span span) {
    const std::size_t kind = made.index();
    name(kind);
    draft_.pattern = std::move(made);
    fields_.rebind(*Patterns::infos[kind], Patterns::address(*draft_.pattern));
    fields_.complete();
    name_span_ = span;
}

/// Reads object { Thing, list }.
bool PatternReader::read_object_pattern(const Element& element) {
    OpenBlock inner(block_.binder, "object", element.word_span);
    const auto found = [&](const Object& object) {
        take_made(object_pattern(object), element.word_span);
    };
    const auto rest = [&](const Element& entry) { return list_entry_ && list_entry_(entry); };
    InsideReader reader(inner, found, rest);
    inner.read(element.body, reader);
    block_.broken |= inner.broken;
    return true;
}

void PatternReader::read_warp(const Element& element) {
    OpenBlock inner(block_.binder, "warp", element.word_span);
    inner.form = warp_form;
    Warp warp;
    WarpReader reader(inner, warp);
    inner.read(element.body, reader);
    block_.broken |= inner.broken;
    if (!inner.broken) draft_.add(std::move(warp));
}

void PatternReader::finish() {
    fields_.finish();
    modifiers_.finish();
    wave_.finish();
    if (!named_ || block_.broken || !belongs_here(name_span_)) return;
    if (auto* file = std::get_if<DensityFile>(&*draft_.pattern))
        load_density(block_, name_span_, *file);
    if (const auto* pavement = std::get_if<Pavement>(&*draft_.pattern))
        check_pavement(block_, name_span_, *pavement);
    const auto* slope = std::get_if<Slope>(&*draft_.pattern);
    const bool empty_slope = slope && !slope->direction && !slope->point_at;
    const auto* grey = std::get_if<PigmentGrey>(&*draft_.pattern);
    const auto* object = std::get_if<ObjectPattern>(&*draft_.pattern);
    if (object && !object->inside.code)
        block_.report(error(Fault::missing, name_span_, "`object` needs an object in braces")
                          .with_help("pigment { object { Thing rgb 1, rgb <1, 0, 0> } }"));
    if (empty_slope || (grey && !grey->grey.code))
        block_.report(error(Fault::missing, name_span_,
                            empty_slope ? "`slope` needs a direction, or `point_at`"
                                        : "`pigment_pattern` needs a pigment in braces")
                          .with_help(empty_slope ? "slope { y }"
                                                 : "pigment_pattern { bozo color_map { ... } }"));
}

bool PatternReader::belongs_here(Span span) {
    const std::string_view only = home(*draft_.pattern), word = pattern_name(*draft_.pattern);
    if (!only.empty() && only != home_)
        block_.report(
            error(Fault::misplaced, span, message('`', word, "` is for ", only, "s only")));
    else if (const PictureMap* picture = picture_of(*draft_.pattern); picture && !picture->texels)
        block_.report(error(Fault::missing, span, message('`', word, "` needs a picture in braces"))
                          .with_help(message(word, " { \"picture.png\" }")));
    else
        return true;
    return false;
}

bool read_pattern(Binder& binder, const Element& element, PatternDraft& draft) {
    OpenBlock block(binder, "pattern", element.word_span);
    block.form = "{ name [values] [transformations] }";
    PatternReader pattern(block, draft, {});
    const auto apply = [&](const Transform& transform) { draft.move(transform); };
    TransformReader moves(block, apply);
    block.read(element.body, pattern, moves);
    if (!block.broken && !draft.pattern)
        block.report(error(Fault::missing, block.span, "`pattern` needs the name of a pattern")
                         .with_help("pattern { granite scale 2 }"));
    return !block.broken;
}

}  // namespace candelabra
