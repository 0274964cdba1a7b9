// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/written.h"

#include "text/message.h"

#include <algorithm>

namespace {

std::string numbers(const double* at, std::size_t count) {
    if (std::all_of(at, at + count, [&](double x) { return x == at[0]; })) return message(at[0]);
    std::string text = "<";
    for (std::size_t i = 0; i < count; ++i) text += message(i > 0 ? ", " : "", at[i]);
    return text + ">";
}

struct Writer {
    FieldType type;

    std::string operator()(std::monostate) const { return {}; }
    std::string operator()(double x) const {
        return type == FieldType::boolean ? (x > 0 ? "on" : "off") : message(x);
    }
    std::string operator()(const Vec2& v) const { return numbers(&v.x, 2); }
    std::string operator()(const Vec3& v) const {
        return (type == FieldType::rgb ? "rgb " : "") + numbers(&v.x, 3);
    }
    std::string operator()(const Colour& c) const {
        const double all[] = {c.rgb.x, c.rgb.y, c.rgb.z, c.filter, c.transmit};
        return c.filter == 0 && c.transmit == 0 ? "rgb " + numbers(all, 3)
                                                : "rgbft " + numbers(all, 5);
    }
    std::string operator()(const std::string& content) const {
        std::string text = "\"";
        for (const char c : content)
            text += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
        return text + '"';
    }
    std::string operator()(const std::vector<Vec3>& list) const {
        std::string text = message("{ ", list.size());
        for (const Vec3& v : list) text += message(", <", v.x, ", ", v.y, ", ", v.z, ">");
        return text + " }";
    }
    std::string operator()(const std::vector<Face>& list) const {
        std::string text = message("{ ", list.size());
        for (const Face& face : list)
            text += message(", <", face[0], ", ", face[1], ", ", face[2], ">");
        return text + " }";
    }
};

}  // namespace

std::string written(const FieldValue& value, FieldType type) {
    return std::visit(Writer{type}, value);
}

std::string written_fields(const ItemInfo& item, const void* object) {
    std::string positional, others;
    for (std::size_t i = 0; i < item.fields.size(); ++i) {
        const FieldInfo& field = item.fields[i];
        const std::string value = written(item.get(object, i), field.type);
        if (field.place == Placement::positional) {
            positional += message(positional.empty() ? "" : ", ", value);
        } else if (!value.empty() && value != written(item.default_value(i), field.type)) {
            others += message(others.empty() ? "" : " ", field.name);
            if (field.place != Placement::flag || value != "on") others += " " + value;
        }
    }
    return message(positional, positional.empty() || others.empty() ? "" : " ", others);
}
