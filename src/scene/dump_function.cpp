// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/dump_function.h"

#include "formula/function_texts.h"
#include "text/message.h"
#include "vocabulary/written.h"

#include <charconv>
#include <cstdint>

namespace candelabra {

namespace {

/// Copies the text, and replaces each number between the two characters.
template <class Replacement>
std::string replaced_between(std::string_view text, char begin, char end, Replacement by) {
    std::string result;
    for (std::size_t at = text.find(begin); at != text.npos; at = text.find(begin)) {
        const std::size_t last = text.find(end, at);
        std::uintptr_t number = 0;
        std::from_chars(text.data() + at + 1, text.data() + last, number);
        result += text.substr(0, at);
        result += by(number);
        text.remove_prefix(last + 1);
    }
    return result += text;
}

}  // namespace

std::string FunctionWriter::replaced(std::string_view text) {
    std::string result(text);
    // The last begin has no other texture within.
    for (std::size_t at = result.rfind(texture_begin); at != result.npos;
         at = at == 0 ? result.npos : result.rfind(texture_begin, at - 1)) {
        const std::size_t from = at + texture_begin.size(), end = result.find(texture_end, at);
        const std::string name = texture_name(std::string_view(result).substr(from, end - from));
        result.replace(at, end + texture_end.size() - at, name);
    }
    return with_functions(result);
}

std::string FunctionWriter::texture_name(std::string_view texture) {
    const std::string text = with_functions(texture);
    const auto [known, added] = textures_.try_emplace(text);
    if (added) {
        known->second = message("Texture_", textures_.size());
        declarations_ += message("#declare ", known->second, " = ", text, "\n");
    }
    return known->second;
}

std::string FunctionWriter::with_functions(std::string_view text) {
    return replaced_between(text, function_begin, function_end, [&](std::uintptr_t address) {
        return written(*reinterpret_cast<const Formula*>(address));
    });
}

std::string FunctionWriter::written(const Formula& function) {
    const FunctionTexts* const texts = FunctionTexts::kept();
    const FormulaText* const text = texts ? texts->find(&function) : nullptr;
    if (!text) return "function { ... }";
    const std::string body =
        replaced_between(text->body, FormulaText::begin, FormulaText::end,
                         [&](std::uintptr_t number) { return name_of(*text->called[number]); });
    const std::string size = function.columns() > 0
                                 ? message(" ", function.columns(), ", ", function.rows())
                             : text->parameters.empty() ? std::string()
                                                        : " " + text->parameters;
    // The body of a pattern has functions of its own.
    return message("function", size, " { ", replaced(body), " }");
}

std::string FunctionWriter::name_of(const Formula& function) {
    if (const auto known = names_.find(&function); known != names_.end()) return known->second;
    const std::string text = written(function);  // declares what it calls
    std::string name = message("Function_", names_.size() + 1);
    declarations_ += message("#declare ", name, " = ", text, ";\n");
    return names_.emplace(&function, std::move(name)).first->second;
}

}  // namespace candelabra
