// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/convert.h"

#include "text/message.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candelabra {

std::string_view kind_name(FieldType type) {
    switch (type) {
        case FieldType::number:
            return "a number";
        case FieldType::integer:
            return "a whole number";
        case FieldType::boolean:
            return "`on` or `off`";
        case FieldType::vector2:
            return "a vector of 2";
        case FieldType::vector3:
            return "a vector";
        case FieldType::vector4:
            return "a vector of 4";
        case FieldType::rgb:
        case FieldType::colour:
            return "a colour";
        case FieldType::text:
            return "a string";
        case FieldType::numbers:
            return "a list of numbers in < >";
        case FieldType::points:
        case FieldType::vectors:
        case FieldType::balls:
        case FieldType::faces:
            break;
        case FieldType::function:
            return "a function";
        case FieldType::parts:
            return "a block";
    }
    return "a list in braces";
}

std::string rule(const Range& range) {
    const bool low = range.low > -std::numeric_limits<double>::infinity();
    const bool high = range.high < std::numeric_limits<double>::infinity();
    if (low && high && !range.low_excluded) return message("from ", range.low, " to ", range.high);
    std::string text;
    if (low) text = message(range.low_excluded ? "above " : "at least ", range.low);
    if (high) text += message(low ? " and " : "", "at most ", range.high);
    return text;
}

const double* offender(const Range& range, const FieldValue& value) {
    const auto find = [&](const double* at, int count) -> const double* {
        for (int i = 0; i < count; ++i)
            if (!range.contains(at[i])) return at + i;
        return nullptr;
    };
    if (const auto* x = std::get_if<double>(&value)) return find(x, 1);
    if (const auto* v = std::get_if<Vec2>(&value)) return find(&v->x, 2);
    if (const auto* v = std::get_if<Vec3>(&value)) return find(&v->x, 3);
    if (const auto* c = std::get_if<Colour>(&value)) return find(&c->rgb.r, 3);
    return nullptr;
}

std::optional<FieldValue> converted(OpenBlock& block, const Element& element, FieldType type,
                                    const Slot& slot) {
    const auto wrong = [&](Fault fault, std::string_view is,
                           std::string_view rule = {}) -> std::optional<FieldValue> {
        const std::string_view expected = !rule.empty()                ? rule
                                          : type == FieldType::vector3 ? "a vector of 3"
                                                                       : kind_name(type);
        if (element.value.broken())
            block.broken = true;
        else
            block.report(error(fault, element.span,
                               message(slot.name(), " must be ", expected, ", but it is ", is))
                             .with_label(message("this is ", is))
                             .with_help(slot.help()));
        return std::nullopt;
    };
    if (type == FieldType::text) {
        if (const std::string* text = element.value.text()) return *text;
        return wrong(Fault::wrong_type, kind_name(element.value));
    }
    if (type == FieldType::function) {
        if (const Handle<Formula> function = element.value.handle<Formula>()) return function;
        return wrong(Fault::wrong_type, kind_name(element.value));
    }
    const Numbers* numbers = element.value.numbers();
    if (!numbers) return wrong(Fault::wrong_type, kind_name(element.value));
    for (int i = 0; i < numbers->count; ++i)
        if (!std::isfinite(numbers->at[i]))
            return wrong(Fault::out_of_range,
                         std::isnan(numbers->at[i]) ? "not a number" : message(numbers->at[i]),
                         "finite");

    switch (type) {
        case FieldType::number:
        case FieldType::boolean:
            if (numbers->is_scalar()) return numbers->at[0];
            return wrong(Fault::wrong_type, kind_name(element.value));
        case FieldType::integer: {
            if (!numbers->is_scalar()) return wrong(Fault::wrong_type, kind_name(element.value));
            const double given = numbers->at[0];
            const double whole = std::round(given);
            if (std::abs(whole) > 2147483647.0)
                return wrong(Fault::out_of_range, message(given),
                             "a whole number up to 2147483647");
            if (std::abs(whole - given) <= 1e-6) return whole;
            // As in POV-Ray, which truncates.
            block.report(warning(Fault::no_effect, element.span,
                                 message(slot.name(), " is a whole number, and ", given,
                                         " counts as ", std::trunc(given))));
            return std::trunc(given);
        }
        case FieldType::vector2:
            if (numbers->count > 2) return wrong(Fault::wrong_count, kind_name(element.value));
            return Vec2(numbers->at[0], numbers->count == 1 ? numbers->at[0] : numbers->at[1]);
        case FieldType::vector3:
            if (numbers->count > 3)
                return wrong(numbers->is_colour() ? Fault::wrong_type : Fault::wrong_count,
                             kind_name(element.value));
            return numbers->promoted(3).vec3();
        case FieldType::vector4: {
            if (numbers->count > 4) return wrong(Fault::wrong_type, kind_name(element.value));
            const Numbers four = numbers->promoted(4);
            return Vec4(four.at[0], four.at[1], four.at[2], four.at[3]);
        }
        case FieldType::rgb:
            return numbers->promoted(3).vec3();
        case FieldType::colour:
            return numbers->is_scalar() ? Colour{Rgb(numbers->at[0])}
                                        : numbers->promoted(5).to_colour();
        case FieldType::numbers:
            return std::vector<double>(numbers->at.begin(), numbers->at.begin() + numbers->count);
        case FieldType::text:
        case FieldType::points:
        case FieldType::vectors:
        case FieldType::balls:
        case FieldType::faces:
        case FieldType::function:
        case FieldType::parts:
            break;
    }
    return wrong(Fault::wrong_type, kind_name(element.value));
}

bool set_fitting(const ItemInfo& info, void* item, std::size_t field, const Numbers& numbers) {
    const FieldInfo& wanted = info.fields[field];
    const bool vector = wanted.type == FieldType::vector3;
    if (numbers.count > (vector ? 3 : 1) || (!vector && wanted.type != FieldType::number))
        return false;
    const auto fits = [&](double x) { return std::isfinite(x) && wanted.range.contains(x); };
    if (!vector) {
        if (!fits(numbers.at[0])) return false;
        info.set(item, field, numbers.at[0]);
        return true;
    }
    const Vec3 v = numbers.count == 3 ? numbers.vec3() : numbers.promoted(3).vec3();
    if (!fits(v.x) || !fits(v.y) || !fits(v.z)) return false;
    info.set(item, field, v);
    return true;
}

bool colour_alone(Body body) {
    return body.tree->get_if<node::Prefixed>(body.first) &&
           (*body.tree)[body.first].next == no_node;
}

std::optional<Colour> computed_colour(Evaluator& evaluator, Body body) {
    Numbers colour;
    if (!evaluator.compute(body, colour) || !colour.is_colour() ||
        !std::ranges::all_of(colour.at, [](double part) { return std::isfinite(part); }))
        return std::nullopt;
    return colour.to_colour();
}

std::optional<Colour> plain_colour(OpenBlock& block, const Element& element) {
    const Numbers* numbers = element.value.numbers();
    if (!numbers || numbers->is_colour()) {
        const auto value =
            converted(block, element, FieldType::colour,
                      {[] { return std::string("this"); }, [&] { return block.help(); }});
        return value ? std::optional(std::get<Colour>(*value)) : std::nullopt;
    }
    const std::string kind = kind_name(element.value);
    block.report(
        error(Fault::wrong_type, element.span, message("expected a colour, but this is ", kind))
            .with_help(numbers->is_scalar() ? message("write `rgb ", numbers->at[0], "`")
                                            : message("write `rgb <", numbers->at[0], ", ",
                                                      numbers->at[1], ", ", numbers->at[2], ">`")));
    return std::nullopt;
}

}  // namespace candelabra
