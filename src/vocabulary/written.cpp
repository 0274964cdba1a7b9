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
    std::string operator()(const std::vector<double>& list) const {
        std::string text = "<";
        for (const double x : list) text += message(text.size() > 1 ? ", " : "", x);
        return text + ">";
    }
    template <class Entry>
    std::string operator()(const std::vector<Entry>& list) const {
        std::string text = message(list.size());
        for (const Entry& each : list) text += ", " + entry(each);
        return text;
    }

    static std::string entry(const Vec2& v) { return message("<", v.x, ", ", v.y, ">"); }
    static std::string entry(const Vec3& v) { return message("<", v.x, ", ", v.y, ", ", v.z, ">"); }
    static std::string entry(const Ball& b) { return message(entry(b.centre), ", ", b.radius); }
    static std::string entry(const Face& f) {
        return message("<", f[0], ", ", f[1], ", ", f[2], ">");
    }
};

}  // namespace

std::string written(const FieldValue& value, FieldType type) {
    return std::visit(Writer{type}, value);
}

std::string written_fields(const ItemInfo& item, const void* object) {
    std::string choices, positional, others;
    for (std::size_t i = 0; i < item.fields.size(); ++i) {
        const FieldInfo& field = item.fields[i];
        const bool flag = field.place == Placement::flag;
        std::string value = written(item.get(object, i), field.type);
        if (field.unnamed()) {
            if (field.entries > 0) value.erase(0, value.find(' ') + 1);
            positional += message(positional.empty() ? "" : ", ", value);
        } else if (!value.empty() && value != written(item.default_value(i), field.type)) {
            std::string& text = field.place == Placement::choice ? choices : others;
            if (field.place == Placement::choice && value != message(field.chosen)) continue;
            text += message(text.empty() ? "" : " ", field.name);
            if (field.place == Placement::list)
                text += " { " + value + " }";
            else if (field.place == Placement::item || (flag && value != "on"))
                text += " " + value;
        }
    }
    std::string all;
    for (const std::string& part : {choices, positional, others})
        all += message(all.empty() || part.empty() ? "" : " ", part);
    return all;
}
