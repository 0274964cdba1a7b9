// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/items.h"

#include "proof/samples.h"
#include "scene/catalogue.h"

#include <algorithm>
#include <cmath>

namespace candelabra::proof {

namespace {

/// Rounded to two digits behind the point, so that scenes are read easily.
std::string number(double value) { return text_of(std::round(value * 100) / 100); }

std::string vector_of(std::size_t size, Dice& dice, double low, double high) {
    std::string text = "<";
    for (std::size_t i = 0; i < size; ++i)
        text += (i > 0 ? ", " : "") + number(dice.between(low, high));
    return text + ">";
}

/// A number near the default, within the range.
double near_default(const Range& range, double usual, Dice& dice) {
    double value = usual != 0 ? usual * std::exp(dice.between(-0.7, 0.7)) : dice.between(0.1, 0.9);
    if (std::isfinite(range.high) && range.high <= 1) value = dice.between(range.low, range.high);
    const double least = range.low_excluded ? range.low + 0.05 : range.low;
    return std::clamp(value, least, std::max(least, range.high));
}

double usual_number(const ItemInfo& item, std::size_t field) {
    const FieldValue value = item.default_value(field);
    const double* number = std::get_if<double>(&value);
    return number && std::isfinite(*number) ? *number : 0;
}

/// Empty where only the table of samples could help.
std::string drawn_value(const ItemInfo& item, std::size_t n, Dice& dice) {
    const FieldInfo& field = item.fields[n];
    if (const auto given = sample(item.name, field.name); !given.empty()) return std::string(given);
    switch (field.type) {
        case FieldType::number:
            return number(near_default(field.range, usual_number(item, n), dice));
        case FieldType::integer:
            return number(std::round(near_default(field.range, usual_number(item, n), dice)));
        case FieldType::boolean:
            return "";
        case FieldType::vector2:
            return vector_of(2, dice, 0.2, 0.9);
        case FieldType::vector3:
            return vector_of(3, dice, std::max(-0.5, field.range.low),
                             std::min(0.8, field.range.high));
        case FieldType::vector4:
            return vector_of(4, dice, std::max(-0.5, field.range.low),
                             std::min(0.5, field.range.high));
        case FieldType::rgb:
            return "rgb " + vector_of(3, dice, 0.1, 0.9);
        case FieldType::colour:
            return drawn_colour(dice);
        default:
            return "?";
    }
}

/// One of the parts of `~a|b~`.
std::string chosen(std::string_view sample, Dice& dice) {
    std::string text;
    while (true) {
        const std::size_t begin = sample.find('~');
        text += sample.substr(0, begin);
        if (begin == sample.npos) return text;
        const std::size_t end = sample.find('~', begin + 1);
        std::vector<std::string_view> parts;
        for (std::size_t at = begin + 1; at <= end;) {
            const std::size_t bar = std::min(sample.find('|', at), end);
            parts.push_back(sample.substr(at, bar - at));
            at = bar + 1;
        }
        text += dice.pick(parts);
        sample.remove_prefix(end + 1);
    }
}

/// Whether the drawn value belongs to the word before it.
bool follows(const ItemInfo& item, std::size_t n) {
    return n < item.fields.size() && item.fields[n].place == Placement::following;
}

}  // namespace

std::span<const ItemInfo* const> items_of(std::string_view group) {
    return std::ranges::find(catalogue(), group, &ItemGroup::name)->items;
}

const ItemInfo& item_of(std::string_view group, std::string_view name) {
    return **std::ranges::find(items_of(group), name, &ItemInfo::name);
}

std::string drawn_colour(Dice& dice, bool clear) {
    if (!clear || dice.chance(0.6)) return "rgb " + vector_of(3, dice, 0.05, 1);
    const double passes = std::round(dice.between(0.2, 0.9) * 100) / 100;
    if (dice.chance(0.5))
        return "rgb " + vector_of(3, dice, 0.3, 1) + " transmit " + text_of(passes);
    return "rgb " + vector_of(3, dice, 0.3, 1) + " filter " + text_of(passes);
}

Element drawn_map(Dice& dice, bool clear) {
    std::string text = "color_map { [0 " + drawn_colour(dice, clear) + "]";
    if (dice.chance(0.4)) text += " [0.5 " + drawn_colour(dice, clear) + "]";
    return words(text + " [1 " + drawn_colour(dice, clear) + "] }");
}

std::string drawn_values(const ItemInfo& item, Dice& dice) {
    // The pattern and the warp `cubic` have the name of a shape, and no values.
    const bool other_cubic = item.name == "cubic" && item.fields.empty();
    if (const auto given = sample(item.name); !given.empty() && !other_cubic)
        return chosen(given, dice);
    std::string text;
    for (std::size_t n = 0; n < item.fields.size(); ++n) {
        const FieldInfo& field = item.fields[n];
        if (field.place != Placement::positional || (field.may_be_left_out && dice.chance(0.5)))
            break;
        text += (text.empty() ? "" : ", ") + drawn_value(item, n, dice);
    }
    return text;
}

std::vector<Element> drawn_words(const ItemInfo& item, Dice& dice, double probability) {
    std::vector<Element> result;
    bool chosen = false;
    for (std::size_t n = 0; n < item.fields.size(); ++n) {
        const FieldInfo& field = item.fields[n];
        const bool file = field.type == FieldType::text && sample(item.name, field.name).empty();
        if (!field.is_word() || file || field.type == FieldType::parts ||
            left_out(item.name, field.name) || !dice.chance(probability))
            continue;
        const bool choice = field.place == Placement::choice;
        if (choice && std::exchange(chosen, true)) continue;
        std::string text(field.name);
        if (!choice && field.place != Placement::flag) text += " " + drawn_value(item, n, dice);
        for (std::size_t more = n + 1; follows(item, more); ++more)
            if (!item.fields[more].may_be_left_out) text += ", " + drawn_value(item, more, dice);
        if (text.find('?') == text.npos) result.push_back(words(text));
    }
    return result;
}

Element drawn(const ItemInfo& item, Dice& dice, double probability) {
    return block(std::string(item.name), drawn_values(item, dice),
                 drawn_words(item, dice, probability));
}

}  // namespace candelabra::proof
