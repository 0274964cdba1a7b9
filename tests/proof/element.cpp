// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/element.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

namespace candelabra::proof {

namespace {

class Writer {
public:
    explicit Writer(const Writing& writing) : writing_(writing) {}

    void add(const Element& element, int light, std::size_t depth) {
        if (element.light >= 0) light = element.light;
        text_.append(4 * depth, ' ');
        if (element.head.empty()) {
            add_values(element.values, light);
            text_ += '\n';
            return;
        }
        text_ += element.head + " { ";
        add_values(element.values, light);
        if (element.inner.empty()) {
            text_ += " }\n";
            return;
        }
        text_ += '\n';
        for (const Element& each : element.inner) add(each, light, depth + 1);
        text_.append(4 * depth, ' ');
        text_ += "}\n";
    }

    std::string text() && { return std::move(text_); }

private:
    void add_values(std::string_view values, int light) {
        for (;;) {
            const std::size_t begin = values.find_first_of("@$");
            text_ += values.substr(0, begin);
            if (begin == values.npos) return;
            const std::size_t end = values.find(values[begin], begin + 1);
            const std::string marked(values.substr(begin + 1, end - begin - 1));
            if (values[begin] == '@')
                add_amount(marked, light);
            else
                add_word(marked);
            values.remove_prefix(end + 1);
        }
    }

    void add_amount(const std::string& amount, int light) {
        char* end = nullptr;
        const double value = std::strtod(amount.c_str(), &end);
        if (*end == '#') light = std::atoi(end + 1);
        text_ += text_of(factor(light) * value);
        if (writing_.marked) text_ += "/*light " + std::to_string(light) + "*/";
    }

    void add_word(const std::string& word) {
        const bool stands = (word == "luminaire") == (writing_.found == Found::sampled);
        if (writing_.marked)
            text_ += (stands ? word : "") + "/*" + word + "*/";
        else if (stands)
            text_ += word;
    }

    double factor(int light) const {
        return writing_.only < 0 || writing_.only == light ? writing_.light : 0;
    }

    const Writing& writing_;
    std::string text_;
};

}  // namespace

std::string written(const Element& element, const Writing& writing) {
    Writer writer(writing);
    writer.add(element, -1, 0);
    return std::move(writer).text();
}

std::string written(const Script& script, const Writing& writing) {
    std::string text = "#version 3.7;\n";
    for (const Element& each : script.elements) text += written(each, writing);
    return text;
}

bool mentions(const Element& element, std::string_view word) {
    return written(element).find(word) != std::string::npos;
}

bool mentions(const Script& script, std::string_view word) {
    return written(script).find(word) != std::string::npos;
}

Element& element_of(Script& script, std::string_view head) {
    const auto found = std::ranges::find(script.elements, head, &Element::head);
    if (found != script.elements.end()) return *found;
    return *script.elements.insert(script.elements.begin(), block(std::string(head), ""));
}

void replace_part(Element& whole, Element part) {
    const auto found = std::ranges::find(whole.inner, part.head, &Element::head);
    if (found != whole.inner.end())
        *found = std::move(part);
    else
        whole.inner.push_back(std::move(part));
}

std::string text_of(double number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    return {digits.data(), end};
}

}  // namespace candelabra::proof
