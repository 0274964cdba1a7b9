// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/indices.h"

#include "text/ascii.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace candelabra {

Span Indices::span(std::size_t i) const {
    if (path.known()) return path;
    NodeId id = first;
    for (; i > 0; --i) id = (*tree)[id].next;
    return tree->span(id);
}

bool Indices::add(std::string text) {
    texts.push_back({count, std::move(text)});
    return add(0.0);
}

bool Indices::add_part(std::string_view part) {
    int number = 0;
    const bool digits = !part.empty() && std::ranges::all_of(part, is_digit);
    const char* const end = part.data() + part.size();
    if (digits && std::from_chars(part.data(), end, number).ec == std::errc()) return add(number);
    return add(std::string(part));
}

bool Indices::expand(std::size_t i) {
    const std::string* const whole = text(i);
    if (!whole || whole->find('.') == whole->npos) return false;
    const auto points = static_cast<std::size_t>(std::ranges::count(*whole, '.'));
    if (count + points > values.size()) return false;
    const Indices before = *this;
    if (!path.known() && tree) path = before.span(i);
    count = 0;
    texts.clear();
    for (std::size_t k = 0; k < before.count; ++k) {
        const std::string* const text = before.text(k);
        if (!text) {
            add(before.values[k]);
        } else if (k != i) {
            add(*text);
        } else {
            for (std::size_t from = 0; from <= text->size();) {
                const std::size_t end = std::min(text->find('.', from), text->size());
                add_part(std::string_view(*text).substr(from, end - from));
                from = end + 1;
            }
        }
    }
    return true;
}

}  // namespace candelabra
