// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/written.h"

#include "base/transform.h"
#include "text/message.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// The number that reads back as the same one, also as the same zero: a function's atan2 depends on
/// the signs of zeros.
std::string exact(double x) { return x == 0 && std::signbit(x) ? "-0" : message(x); }

std::string numbers(const double* at, std::size_t count) {
    const std::string first = exact(at[0]);
    if (std::all_of(at, at + count, [&](double x) { return exact(x) == first; })) return first;
    std::string text = "<" + first;
    for (std::size_t i = 1; i < count; ++i) text += ", " + exact(at[i]);
    return text + ">";
}

struct Writer {
    FieldType type;

    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(double x) const {
        return type == FieldType::boolean ? (x > 0 ? "on" : "off") : exact(x);
    }
    std::string operator()(const Vec2& v) const { return numbers(&v.x, 2); }
    std::string operator()(const Vec3& v) const {
        return (type == FieldType::rgb ? "rgb " : "") + numbers(&v.x, 3);
    }
    std::string operator()(const Vec4& v) const { return numbers(&v.x, 4); }
    std::string operator()(const Colour& c) const {
        const double all[] = {c.rgb.r, c.rgb.g, c.rgb.b, c.filter, c.transmit};
        return c.filter == 0 && c.transmit == 0 ? "rgb " + numbers(all, 3)
                                                : "rgbft " + numbers(all, 5);
    }
    std::string operator()(const std::string& content) const {
        std::string text = "\"";
        for (const char c : content)
            text += c == '"' || c == '\\' ? std::string{'\\', c}
                    : c == function_begin || c == function_end
                        ? message("\\u000", static_cast<int>(c))
                        : std::string(1, c);
        return text + '"';
    }
    std::string operator()(const std::vector<double>& list) const {
        std::string text = "<";
        for (const double x : list) text += (text.size() > 1 ? ", " : "") + exact(x);
        return text + ">";
    }
    std::string operator()(const Handle<Formula>& function) const {
        if (!function) return {};
        const auto address = reinterpret_cast<std::uintptr_t>(function.get());
        return message(function_begin, address, function_end);
    }
    template <class Entry>
    std::string operator()(const std::vector<Entry>& list) const {
        std::string text = message(list.size());
        for (const Entry& each : list) text += ", " + entry(each);
        return text;
    }

    static std::string entry(const Vec2& v) {
        return message("<", exact(v.x), ", ", exact(v.y), ">");
    }
    static std::string entry(const Vec3& v) {
        return message("<", exact(v.x), ", ", exact(v.y), ", ", exact(v.z), ">");
    }
    static std::string entry(const Ball& b) {
        return message(entry(b.centre), ", ", exact(b.radius));
    }
    static std::string entry(const Face& f) {
        return message("<", f[0], ", ", f[1], ", ", f[2], ">");
    }
};

}  // namespace

std::string written(const FieldValue& value, FieldType type) {
    return std::visit(Writer{type}, value);
}

std::string matrix_text(const Transform& transform) {
    if (transform == Transform()) return {};
    std::string text = " matrix <";
    const auto add = [&](const Affine& map) {
        for (const Vec3& row : {map.rows[0], map.rows[1], map.rows[2], map.translation})
            for (const double x : {row.x, row.y, row.z})
                text += (text.back() == '<' ? "" : ", ") + exact(x);
    };
    add(transform.forward());
    if (transform != Transform(transform.forward())) add(transform.inverse().forward());
    return text + ">";
}

namespace {

/// Writes faces, each followed by its texture numbers.
std::string faces_text(const std::vector<Face>& faces, const std::vector<Face>& looks) {
    std::string text = message(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        text += ", " + Writer::entry(faces[i]);
        const auto [a, b, c] = looks[i];
        if (a >= 0)
            text += a == b && b == c ? message(", ", a) : message(", ", a, ", ", b, ", ", c);
    }
    return text;
}

/// Writes a list with the values that follow each entry.
std::string list_text(const ItemInfo& item, const void* object, std::size_t i) {
    const FieldValue value = item.get(object, i);
    const auto* faces = std::get_if<std::vector<Face>>(&value);
    const bool followed =
        faces && i + 1 < item.fields.size() && item.fields[i + 1].place == Placement::following;
    if (followed) {
        const FieldValue next = item.get(object, i + 1);
        const auto* looks = std::get_if<std::vector<Face>>(&next);
        if (looks && !looks->empty()) return faces_text(*faces, *looks);
    }
    return written(value, item.fields[i].type);
}

/// Writes the parts in a list as blocks.
std::string parts_text(const FieldInfo& field, const void* object, WrittenLook look) {
    std::string text;
    for (std::size_t i = 0; i < field.parts->count(object); ++i) {
        const void* part = field.parts->at(object, i);
        const bool loose = field.place == Placement::loose_part;
        text += message(text.empty() ? "" : " ", field.name, loose ? " " : " { ",
                        written_fields(field.parts->info(), part));
        if (loose) continue;
        // The accessors take mutable parts, but nothing is changed through them.
        void* const open = const_cast<void*>(part);
        if (field.parts->transform) text += matrix_text(*field.parts->transform(open));
        if (const int number = field.parts->looks == 1 ? *field.parts->look(open) : -1; number >= 0)
            text += look(number);
        text += " }";
    }
    return text;
}

/// The values of a field and of those that follow it, without trailing optional defaults; empty if
/// all have their defaults.
std::string item_values(const ItemInfo& item, const void* object, std::size_t first) {
    std::string text, waiting;
    bool changed = false;
    for (std::size_t i = first; i < item.fields.size(); ++i) {
        const FieldInfo& field = item.fields[i];
        if (i > first && field.place != Placement::following) break;
        const std::string value = written(item.get(object, i), field.type);
        if (value.empty() && i == first) return {};
        if (value.empty()) break;
        const bool differs = value != written(item.default_value(i), field.type);
        changed = changed || differs;
        waiting += (i > first ? ", " : "") + value;
        if (!differs && i > first && field.may_be_left_out) continue;
        text += waiting;
        waiting.clear();
    }
    return changed ? text : std::string();
}

/// A field with a word as written in the text; empty if it has its default.
std::string worded(const ItemInfo& item, const void* object, std::size_t i, WrittenLook look) {
    const FieldInfo& field = item.fields[i];
    const std::string name(field.name), value = written(item.get(object, i), field.type);
    const bool changed = !value.empty() && value != written(item.default_value(i), field.type);
    switch (field.place) {
        case Placement::parts:
        case Placement::loose_part:
            return parts_text(field, object, look);
        case Placement::item: {
            const std::string values = item_values(item, object, i);
            return values.empty() ? values : name + " " + values;
        }
        case Placement::choice:
            return changed && value == message(field.chosen) ? name : std::string();
        case Placement::flag:
            return !changed ? std::string() : value == "on" ? name : name + " " + value;
        case Placement::list:
            return changed ? name + " { " + list_text(item, object, i) + " }" : std::string();
        default:
            return {};
    }
}

}  // namespace

std::string written_fields(const ItemInfo& item, const void* object) {
    return written_fields(item, object, [](int) { return std::string(); });
}

std::string written_fields(const ItemInfo& item, const void* object, WrittenLook look) {
    std::string choices, positional, others;
    bool unset = false;
    for (std::size_t i = 0; i < item.fields.size(); ++i) {
        const FieldInfo& field = item.fields[i];
        if (field.unnamed()) {
            std::string value = written(item.get(object, i), field.type);
            if (value.empty()) unset = true;  // an unset optional: later values were not given
            if (unset) continue;
            if (field.entries > 0) value.erase(0, value.find(' ') + 1);
            positional += message(positional.empty() ? "" : ", ", value);
            continue;
        }
        const std::string text = worded(item, object, i, look);
        std::string& to = field.place == Placement::choice ? choices : others;
        to += message(to.empty() || text.empty() ? "" : " ", text);
    }
    std::string all;
    for (const std::string& part : {choices, positional, others})
        all += message(all.empty() || part.empty() ? "" : " ", part);
    return all;
}

}  // namespace candelabra
