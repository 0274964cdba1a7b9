// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/item_reader.h"

#include "reading/lists.h"
#include "reading/parts.h"
#include "reading/rendered_ranges.h"
#include "reading/unbracketed_vector.h"
#include "text/message.h"
#include "vocabulary/manual.h"

#include <cassert>

namespace candelabra {

namespace {

/// Whether the value may be a parameter, not a part of a scene, which other readers take.
bool may_be_parameter(const Value& value) {
    return value.numbers() || value.text() || value.array() || value.formula();
}

}  // namespace

ItemReader::ItemReader(OpenBlock& block, const ItemInfo& info, void* item) : block_(block) {
    rebind(info, item);
}

void ItemReader::rebind(const ItemInfo& info, void* item, Span word) {
    assert(info.fields.size() <= 64 && !waiting());
    item_span_ = word;
    info_ = &info;
    item_ = item;
    positional_ = info.positional;
    next_ = 0;
    given_ = 0;
    entries_left_ = -1;
    centre_.reset();
}

void ItemReader::alone(std::string_view word, double value) {
    alone_ = find(word);
    alone_value_ = value;
}

bool ItemReader::given(std::string_view field) const {
    const int i = find(field);
    return i >= 0 && (given_ >> i & 1) != 0;
}

bool ItemReader::required_missing() const {
    return next_ < positional_ && !info_->fields[next_].may_be_left_out;
}

void ItemReader::add_words(WordList& words) const {
    for (const FieldInfo& field : info_->fields)
        if (field.is_word()) words.push_back(field.name);
}

int ItemReader::find(std::string_view word) const {
    for (std::size_t i = positional_; i < info_->fields.size(); ++i)
        if (info_->fields[i].name == word && info_->fields[i].is_word()) return static_cast<int>(i);
    return -1;
}

int ItemReader::find(NameId word) const {
    if (word == no_name) return -1;
    if (word == "fade_colour"_word) word = "fade_color"_word;
    if (!block_.binder.evaluator.names().reserved(word)) {
        const std::string_view spelling = block_.spelling(word);
        return find(spelling == "grey_threshold" ? "gray_threshold" : spelling);
    }
    for (std::size_t i = positional_; i < info_->fields.size(); ++i)
        if (info_->fields[i].word == word && info_->fields[i].is_word()) return static_cast<int>(i);
    return -1;
}

bool ItemReader::follows(int field) const {
    return field < static_cast<int>(info_->fields.size()) &&
           info_->fields[field].place == Placement::following;
}

bool ItemReader::take(const Element& element) {
    stored_ = -1;
    switch (element.kind) {
        case Element::Kind::value:
            return take_value(element);
        case Element::Kind::word:
            return take_word(element);
        case Element::Kind::block:
            return take_block(element);
        case Element::Kind::list:
            return take_list(element);
        case Element::Kind::entry:
        case Element::Kind::braces:
        case Element::Kind::joined:
        case Element::Kind::omitted:
            break;
    }
    if (word_ >= 0) missing_value();
    end_switch();
    return false;
}

/// Takes a list that has more numbers than a vector can hold.
bool ItemReader::take_list(const Element& element) {
    end_switch();
    if (word_ < 0 && next_ >= positional_) return false;
    const int field = word_ >= 0 ? std::exchange(word_, -1) : next_++;
    if (info_->fields[field].type == FieldType::numbers) {
        set(field, std::vector<double>(element.list.begin(), element.list.end()), element.span);
        return true;
    }
    block_.report(error(Fault::wrong_count, element.span,
                        message(of_block(field), " must be ", kind_name(info_->fields[field].type),
                                ", but this has ", element.list.size(), " numbers"))
                      .with_help(help(field)));
    return true;
}

bool ItemReader::take_value(const Element& element) {
    if (element.value.is(Absence::nothing)) return word_ >= 0 || next_ < positional_;
    const bool scalar = element.value.numbers() && element.value.numbers()->is_scalar();
    if (word_ >= 0 && word_ == alone_ && !scalar && !element.value.broken()) missing_value();
    if (loose_part_) {
        take_loose(element);
        return true;
    }
    if (word_ >= 0) {
        store_and_go_on(std::exchange(word_, -1), element);
        return true;
    }
    // The scene has declared a name that is a word here. No value is expected, so the word is
    // meant.
    if (switch_ < 0 && !required_missing() && element.word != no_name &&
        !block_.binder.evaluator.names().reserved(element.word)) {
        const int field = find(element.word);
        if (field >= 0) {
            begin(field, element.span);
            return true;
        }
    }
    if (switch_ >= 0 && scalar && !required_missing()) {
        store_and_go_on(std::exchange(switch_, -1), element);
        return true;
    }
    end_switch();
    if (next_ == positional_ && entry_count_ > 0 && element.value.numbers() && !block_.broken) {
        block_.report(error(Fault::wrong_count, element.span,
                            message(block_.quoted(), " has ", entry_count_, " `",
                                    info_->fields[next_ - 1].name, "`, but here is one more value"))
                          .with_help(block_.help()));
        return true;
    }
    const auto is_function = [](const FieldInfo& field) {
        return field.type == FieldType::function && field.may_be_left_out;
    };
    if (next_ < positional_ && is_function(info_->fields[next_]) && !element.value.formula())
        ++next_;
    if (next_ >= positional_ || !(may_be_parameter(element.value) || element.value.broken()))
        return false;
    if (info_->fields[next_].place == Placement::counted)
        take_counted(element);
    else
        store(next_++, element);
    return true;
}

/// Takes a value of the part whose word was read last.
void ItemReader::take_loose(const Element& element) {
    const ItemInfo& info = info_->fields[word_].parts->info();
    const FieldInfo& field = info.fields[static_cast<std::size_t>(loose_next_)];
    const auto name = [&] { return message('`', field.name, "` of `", info.name, '`'); };
    const auto help = [&] { return usage(info); };
    auto value = converted(block_, element, field.type, {name, help});
    if (value && in_range(info, field, {name, help}, *value, element.span))
        info.set(loose_part_, static_cast<std::size_t>(loose_next_), *value);
    if (++loose_next_ < info.positional) return;
    loose_part_ = nullptr;
    word_ = -1;
}

void ItemReader::take_counted(const Element& element) {
    if (!counting() && info_->fields[next_].entries > 0)
        begin_entries(info_->fields[next_].entries);
    if (counting())
        take_entry(element);
    else
        take_count(element);
    if (counting() && entries_left_ == 0) {
        entries_left_ = -1;
        set(next_++, entries_, element.span);
        entries_ = {};
    }
}

void ItemReader::take_count(const Element& element) {
    const auto count = converted(
        block_, element, FieldType::integer,
        {[&] { return message("the count of ", of_block(next_)); }, [&] { return help(next_); }});
    if (count && std::get<double>(*count) >= 0)
        return begin_entries(static_cast<int>(std::get<double>(*count)));
    if (count)
        block_.report(error(Fault::out_of_range, element.span,
                            message("the count of ", of_block(next_),
                                    " must be at least 0, but it is ", std::get<double>(*count)))
                          .with_help(help(next_)));
    block_.broken = true;
}

void ItemReader::begin_entries(int count) {
    entry_count_ = entries_left_ = count;
    const FieldType type = info_->fields[next_].type;
    entries_ = type == FieldType::points  ? FieldValue(std::vector<Vec2>())
               : type == FieldType::balls ? FieldValue(std::vector<Ball>())
                                          : FieldValue(std::vector<Vec3>());
}

void ItemReader::take_entry(const Element& element) {
    const FieldInfo& info = info_->fields[next_];
    const FieldType type = info.type == FieldType::points ? FieldType::vector2
                           : centre_                      ? FieldType::number
                                                          : FieldType::vector3;
    const auto value = converted(
        block_, element, type,
        {[&] { return message("an entry of ", of_block(next_)); }, [&] { return help(next_); }});
    if (info.type == FieldType::balls && !centre_) {
        centre_ = value ? std::get<Vec3>(*value) : Vec3(0);
        return;
    }
    --entries_left_;
    if (!value) return centre_.reset();
    if (info.type == FieldType::points)
        std::get<std::vector<Vec2>>(entries_).push_back(std::get<Vec2>(*value));
    else if (info.type == FieldType::balls)
        std::get<std::vector<Ball>>(entries_).push_back({*centre_, std::get<double>(*value)});
    else
        std::get<std::vector<Vec3>>(entries_).push_back(std::get<Vec3>(*value));
    centre_.reset();
}

bool ItemReader::take_word(const Element& element) {
    end_switch();
    const int field = find(element.word);
    if (word_ >= 0) {
        const bool reserved = block_.binder.evaluator.names().reserved(element.word);
        if (field < 0 && !reserved && word_ != alone_) return false;
        if (field < 0 && reserved && word_ != alone_ &&
            !block_.binder.blocks.knows(block_.spelling(element.word)))
            word_ = -1;
        else
            missing_value();
    }
    if (field < 0) return false;
    begin(field, element.span);
    return true;
}

bool ItemReader::take_block(const Element& element) {
    end_switch();
    if (word_ >= 0) missing_value();
    const int field = find(element.word);
    if (field >= 0 && info_->fields[field].place == Placement::parts) {
        read_part(block_, info_->fields[field], item_, element);
        return true;
    }
    if (field < 0 || info_->fields[field].place != Placement::list) return false;
    word_span_ = element.word_span;
    read_list(field, element);
    return true;
}

/// Begins a field after its word.
void ItemReader::begin(int field, Span word) {
    if (word_ >= 0) missing_value();
    word_span_ = word;
    if (info_->fields[field].place == Placement::choice) {
        set(field, info_->fields[field].chosen, word);
        return;
    }
    if (info_->fields[field].place != Placement::flag) {
        word_ = field;
        if (info_->fields[field].place == Placement::loose_part) {
            loose_part_ = info_->fields[field].parts->add(item_);
            loose_next_ = 0;
        }
        return;
    }
    set(field, 1.0, word);
    switch_ = field;
}

/// Stores the value of a word or a subsequent value, and expects the next one if there is one.
void ItemReader::store_and_go_on(int field, const Element& element) {
    store(field, element);
    if (follows(field + 1))
        (info_->fields[field + 1].may_be_left_out ? switch_ : word_) = field + 1;
}

void ItemReader::store(int field, const Element& element) {
    block_.broken |= element.value.broken();
    if (element.value.broken()) return;
    const FieldInfo& info = info_->fields[field];
    if (element.value.numbers() && info.type == FieldType::boolean)
        given_ &= ~(std::uint64_t{1} << field);
    const auto name = [&] { return of_block(field); };
    const auto way_out = [&] { return help(field); };
    auto value = converted(block_, element, info.type, {name, way_out});
    if (value && field < positional_ && offender(info.range, *value))
        if (const auto bare = unbracketed_vectors(element, *info_)) return block_.report(*bare);
    if (info.type == FieldType::text && info.name != "text")  // all other texts are file names
        block_.note_file(element.span, info.is_word() ? info.name : std::string_view());
    if (value && in_range(*info_, info, {name, way_out}, *value, element.span))
        set(field, *value, element.span);
}

void ItemReader::set(int field, const FieldValue& value, Span) {
    const std::uint64_t bit = std::uint64_t{1} << field;
    if ((given_ & bit) != 0 && !repeatable_)
        block_.report(warning(Fault::duplicate, word_span_,
                              message(of_block(field), " is given again; this one counts")));
    given_ |= bit;
    info_->set(item_, static_cast<std::size_t>(field), value);
    stored_ = field;
}

bool ItemReader::in_range(const ItemInfo& info, const FieldInfo& field, const Slot& slot,
                          FieldValue& value, Span span) {
    const Range& range = field.range;
    if (double* number = std::get_if<double>(&value); number && range.any_sign)
        *number = std::abs(*number);
    const double* wrong = offender(range, value);
    if (!wrong) return true;
    if (const RenderedRange* rendered = rendered_range(info.name, field.name)) {
        const double given = *wrong, counts = bring_into(range, *rendered, value);
        block_.report(warning(Fault::no_effect, span,
                              message(slot.name(), " should be ", rule(range), ", but it is ",
                                      given, ": ", counts, " counts"))
                          .with_help(slot.help()));
        return true;
    }
    block_.report(error(Fault::out_of_range, span,
                        message(slot.name(), " must be ", rule(range), ", but it is ", *wrong))
                      .with_label(message("this is ", *wrong))
                      .with_help(slot.help()));
    return false;
}

void ItemReader::missing_value() {
    const int field = std::exchange(word_, -1);
    loose_part_ = nullptr;
    if (field == alone_) {
        set(field, alone_value_, word_span_);
        return;
    }
    block_.report(error(Fault::missing, word_span_,
                        message(of_block(field), follows(field) ? " is missing, " : " needs ",
                                kind_name(info_->fields[field].type)))
                      .with_help(help(field)));
}

void ItemReader::finish() {
    if (word_ >= 0) missing_value();
    if (block_.broken || !required_missing()) return;
    if (counting()) {
        block_.report(
            error(Fault::wrong_count, block_.span,
                  message(of_block(next_), " are counted as ", entry_count_, ", but there ",
                          entry_count_ - entries_left_ == 1 ? "is only " : "are only ",
                          entry_count_ - entries_left_))
                .with_help(block_.help()));
        return;
    }
    std::string names, values;
    for (int i = next_; i < positional_ && !info_->fields[i].may_be_left_out; ++i) {
        const bool last = i + 1 == positional_ || info_->fields[i + 1].may_be_left_out;
        names += message(names.empty() ? ""
                         : last        ? " and "
                                       : ", ",
                         '`', info_->fields[i].name, '`');
        values += message(' ', info_->fields[i].name);
    }
    const bool own = item_span_.known();
    block_.report(
        error(Fault::missing, own ? item_span_ : block_.span,
              message(own ? message('`', info_->name, '`') : block_.quoted(), " needs ", names))
            .with_help(own ? message(block_.name, " { ", info_->name, values, " }")
                           : block_.help()));
}

void ItemReader::read_list(int field, const Element& element) {
    const FieldInfo& info = info_->fields[field];
    OpenBlock inner(block_.binder, info.name, element.word_span);
    inner.form = info.type == FieldType::faces ? "{ count, <a, b, c>, <d, e, f>, ... }"
                                               : "{ count, <x, y, z>, <x, y, z>, ... }";
    std::optional<CountedList> list = read_counted_list(inner, element.body, info.type);
    block_.broken |= inner.broken;
    if (list) set(field, list->value, element.word_span);
    if (list && !list->looks.empty() && follows(field + 1))
        set(field + 1, std::move(list->looks), element.word_span);
}

std::string ItemReader::of_block(int field) const {
    const std::string_view further = further_value(*info_, static_cast<std::size_t>(field));
    if (further.empty()) return message('`', info_->fields[field].name, "` of ", block_.quoted());
    const std::size_t word = word_of(*info_, static_cast<std::size_t>(field));
    return message(further, " of `", info_->fields[word].name, '`');
}

std::string ItemReader::help(int field) const {
    const auto at = static_cast<std::size_t>(field);
    const std::string_view name = info_->fields[at].name, further = further_value(*info_, at);
    const std::string values =
        message(further.empty() ? name : further, ": ", candelabra::values(*info_, at));
    if (info_->fields[at].unnamed()) return message(block_.help(), "   ", values);
    const std::string written = term(*info_, word_of(*info_, at));
    return message(block_.name, " { ... ", written, " ... }   ", values);
}

}  // namespace candelabra
