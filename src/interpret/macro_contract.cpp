// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/macro_contract.h"

#include "interpret/array_data.h"
#include "text/message.h"
#include "vocabulary/words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

namespace {

constexpr auto contract_kinds = std::to_array<std::string_view>(
    {"number",    "whole",      "vector",  "color",       "colour",      "string",
     "array",     "function",   "object",  "transform",   "spline",      "texture",
     "pigment",   "normal",     "finish",  "interior",    "media",       "material",
     "density",   "fog",        "rainbow", "camera",      "color_map",   "colour_map",
     "slope_map", "normal_map", "photons", "pigment_map", "texture_map", "light_source"});

/// The name of a kind as `kind_name` has it.
std::string kind_with_article(std::string_view word) {
    return word == "color_map" ? "a colour map" : with_article(word);
}

std::string numbers_text(const Numbers& numbers) {
    if (numbers.is_scalar()) return message(numbers.at[0]);
    std::string text = "<";
    for (int i = 0; i < numbers.count; ++i) text += message(i > 0 ? ", " : "", numbers.at[i]);
    return text + ">";
}

bool holds(double number, const MacroContract::Limit& limit) {
    switch (limit.sign) {
        case Operator::less:
            return number < limit.value;
        case Operator::less_equal:
            return number <= limit.value;
        case Operator::greater_equal:
            return number >= limit.value;
        default:
            return number > limit.value;
    }
}

std::string value_text(const MacroContract::Limit& limit) {
    return limit.name.empty() ? message(limit.value)
                              : message('`', limit.name, "` (", limit.value, ')');
}

std::string dimensions_text(std::size_t count) {
    return message(count, count == 1 ? " dimension" : " dimensions");
}

/// The words of a bound for numbers and for a count of elements.
std::string bound_text(const MacroContract::Limit& limit, bool count) {
    switch (limit.sign) {
        case Operator::less:
            return message(count ? "fewer than " : "below ", value_text(limit));
        case Operator::less_equal:
            return message(count ? "at most " : "of at most ", value_text(limit));
        case Operator::greater_equal:
            return message(count ? "at least " : "of at least ", value_text(limit));
        default:
            return message(count ? "more than " : "above ", value_text(limit));
    }
}

/// " from 0 to 1", " above 0", " of at least 1 and below 5"; of elements: " with at least 2
/// elements". Empty without limits.
std::string range_text(const std::vector<MacroContract::Limit>& limits, bool count) {
    if (!count && limits.size() == 2 && limits[0].sign == Operator::greater_equal &&
        limits[1].sign == Operator::less_equal)
        return message(" from ", value_text(limits[0]), " to ", value_text(limits[1]));
    std::string text;
    for (const MacroContract::Limit& limit : limits)
        text +=
            message(text.empty() ? (count ? " with " : " ") : " and ", bound_text(limit, count));
    return text.empty() || !count ? text : text + " elements";
}

}  // namespace

MacroContract MacroContract::read(const Tree& tree, NodeId first, const Names& names,
                                  Diagnostics& diagnostics) {
    MacroContract result;
    for (NodeId id = first; id != no_node; id = tree[id].next) {
        if (const auto* bound = tree.get_if<node::Bound>(id)) {
            result.bounds_.push_back(*bound);
            continue;
        }
        const auto& kind = tree.get<node::Kind>(id);
        const std::string_view word = names.spelling(kind.word);
        if (word == "or") continue;
        if (std::ranges::find(contract_kinds, word) == contract_kinds.end()) {
            std::string list;
            for (const std::string_view each : contract_kinds)
                list += message(list.empty() ? "" : ", ", each);
            diagnostics.add(error(Fault::unknown_word, tree.span(id),
                                  message("`", word, "` is no kind of value"))
                                .with_help("kinds of arguments are " + list));
        } else if (word == "whole") {
            result.whole_ = true;
        } else if (word == "number") {
            result.kinds_.push_back({Kind::Of::number, "a number", 0});
        } else if (word == "vector" || word == "color" || word == "colour") {
            result.kinds_.push_back(
                {Kind::Of::vector, word == "vector" ? "a vector" : "a colour", 0});
        } else {
            result.kinds_.push_back({Kind::Of::other, kind_with_article(word), kind.dimensions});
        }
    }
    const auto is_shared = [](const Kind& kind) { return kind.of == Kind::Of::other; };
    if (std::ranges::all_of(result.kinds_, is_shared) &&
        (result.whole_ || (result.kinds_.empty() && !result.bounds_.empty())))
        result.kinds_.insert(result.kinds_.begin(), {Kind::Of::number, "a number", 0});
    const auto has_bounds = [](const Kind& kind) {
        return kind.of != Kind::Of::other || kind.name == "an array";
    };
    if (!result.bounds_.empty() && std::ranges::none_of(result.kinds_, has_bounds))
        diagnostics.add(error(Fault::wrong_type, tree.span(first),
                              message("bounds are for numbers, vectors and arrays, not for ",
                                      result.kinds_.front().name)));
    return result;
}

const MacroContract::Kind* MacroContract::kind_of(const Value& value) const {
    const Numbers* numbers = value.numbers();
    const auto accepts = [&](const Kind& kind) {
        if (kind.of == Kind::Of::number) return numbers && numbers->is_scalar();
        if (kind.of == Kind::Of::vector) return numbers != nullptr;
        if (numbers || kind_name(value) != kind.name) return false;
        return kind.dimensions == 0 || value.array()->sizes().size() == kind.dimensions;
    };
    const auto found = std::ranges::find_if(kinds_, accepts);
    return found == kinds_.end() ? nullptr : &*found;
}

bool MacroContract::within(const Value& value, const std::vector<Limit>& limits) const {
    const auto fits = [&](double number) {
        return std::ranges::all_of(limits, [&](const Limit& l) { return holds(number, l); });
    };
    if (const Numbers* numbers = value.numbers()) {
        const auto* first = numbers->at.data();
        return std::all_of(first, first + numbers->count, [&](double number) {
            return fits(number) &&
                   (!whole_ || (std::isfinite(number) && number == std::floor(number)));
        });
    }
    const ArrayData* array = value.array();
    return !array || fits(static_cast<double>(array->sizes().front()));
}

std::string MacroContract::expected(const std::vector<Limit>& limits) const {
    std::string text;
    const std::string range = range_text(limits, false);
    for (const Kind& kind : kinds_) {
        text += text.empty() ? "" : " or ";
        if (kind.of == Kind::Of::number)
            text += message(whole_ ? "a whole number" : kind.name, range);
        else if (kind.of == Kind::Of::vector)
            text += message(kind.name,
                            whole_          ? " of whole numbers"
                            : range.empty() ? ""
                                            : " of numbers",
                            range);
        else
            text += kind.name;
        if (kind.dimensions > 0) text += message(" of ", dimensions_text(kind.dimensions));
        if (kind.name == "an array") text += range_text(limits, true);
    }
    return text;
}

std::string MacroContract::refusal(const Value& value, const std::vector<Limit>& limits) const {
    if (empty()) return {};
    const Kind* kind = kind_of(value);
    if (kind && within(value, limits)) return {};
    if (const Numbers* numbers = value.numbers())
        return message(expected(limits), ", but it is ", numbers_text(*numbers));
    const ArrayData* array = value.array();
    if (!array) return message(expected(limits), ", but it is ", kind_name(value));
    if (kind) return message(expected(limits), ", but it has ", array->sizes().front());
    return message(expected(limits), ", but it is an array of ",
                   dimensions_text(array->sizes().size()));
}

}  // namespace candelabra
