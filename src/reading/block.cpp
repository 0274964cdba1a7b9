// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/block.h"

#include "text/message.h"
#include "vocabulary/manual.h"

namespace candelabra {

std::string OpenBlock::quoted() const { return name.empty() ? "a scene" : message('`', name, '`'); }

std::string OpenBlock::help() const {
    if (!form.empty()) return message(name, ' ', form);
    if (!item) return {};
    const std::string text = usage(*item, item->name == name ? std::string_view() : name);
    // A usage text of thirty words would not be read.
    constexpr std::size_t most = 110;
    const std::size_t end = text.size() <= most ? text.npos : text.rfind(" [", most);
    return end == text.npos ? text : message(text.substr(0, end), " ... }");
}

void OpenBlock::report(Diagnostic diagnostic) {
    broken |= diagnostic.severity == Severity::error;
    binder.evaluator.report(std::move(diagnostic));
}

void OpenBlock::refuse(const Element& element, const WordList& words) {
    if (!misplaced_.passes_over(element))
        misplaced_.reject(element, words, element.kind == Element::Kind::word);
}

}  // namespace candelabra
