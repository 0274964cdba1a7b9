// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/value.h"

#include "interpret/array_data.h"
#include "text/message.h"
#include "text/printable.h"

namespace candelabra {

Numbers Numbers::promoted(int n) const {
    Numbers result = *this;
    if (n <= count) return result;
    for (int i = count; i < n; ++i) result.at[static_cast<std::size_t>(i)] = count == 1 ? at[0] : 0;
    result.count = n;
    return result;
}

std::string with_article(std::string_view word) {
    constexpr std::string_view vowels = "aeiou";
    std::string result = vowels.find(word.front()) == vowels.npos ? "a " : "an ";
    for (const char c : word) result += c == '_' ? ' ' : c;
    return result;
}

std::string* Value::own_text() {
    return holds<std::string>() && alone() ? &shared_.handle.edit<std::string>() : nullptr;
}

ArrayData& Value::edit_array() { return shared_.handle.edit<ArrayData>(); }

std::string kind_name(const Value& value) {
    constexpr auto numbers = std::array<std::string_view, 5>{
        "a number", "a vector of 2", "a vector of 3", "a vector of 4", "a colour"};
    if (const Numbers* found = value.numbers())
        return std::string(numbers[static_cast<std::size_t>(found->count) - 1]);
    if (value.absent()) return "nothing";
    if (value.macro()) return "a macro";
    return value.shared_.kind->name();
}

std::string kind_and_text(const Value& value) {
    constexpr std::size_t shown = 40;
    const std::string* text = value.text();
    if (!text) return kind_name(value);
    if (text->empty()) return "an empty string";
    const bool whole = text->size() <= shown;
    return message("the string \"", printable(text->substr(0, shown)), whole ? "\"" : "...\"");
}

}  // namespace candelabra
