// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/highlights.h"

#include "syntax/token_classes.h"

#include <algorithm>
#include <unordered_set>

namespace candelabra {

namespace {

std::vector<WordHighlight> places_of(const EditedFile& file, NameId name) {
    std::unordered_set<std::uint32_t> written;
    for (const DeclaredName& each : file.declarations) written.insert(each.place.first);
    std::vector<WordHighlight> found;
    for (const Token& token : file.tokens)
        if (token.kind == TokenKind::name && NameId(token.value) == name)
            found.push_back(
                {{token.first, token.last},
                 written.contains(token.first) ? WordHighlight::write : WordHighlight::read});
    return found;
}

/// Returns the opening word, the dividers and the #end of the directive to which the token belongs.
std::vector<WordHighlight> parts_of_directive(const EditedFile& file, const Token& asked) {
    std::vector<std::vector<WordHighlight>> open;
    for (const Token& token : file.tokens) {
        const Part place{token.first, token.last};
        if (opens_directive(token.kind))
            open.push_back({{place, WordHighlight::text}});
        else if (!open.empty() &&
                 (divides_directive(token.kind) || token.kind == TokenKind::hash_end))
            open.back().push_back({place, WordHighlight::text});
        if (token.kind != TokenKind::hash_end || open.empty()) continue;
        const bool found = std::ranges::any_of(open.back(), [&](const WordHighlight& each) {
            return each.place.first == asked.first;
        });
        if (found) return open.back();
        open.pop_back();
    }
    return {};
}

}  // namespace

std::vector<WordHighlight> highlights(const EditedFile& file, std::uint32_t offset) {
    const Token* const token = file.token_at(offset);
    if (!token) return {};
    if (token->kind == TokenKind::name) return places_of(file, NameId(token->value));
    if (is_directive(token->kind)) return parts_of_directive(file, *token);
    return {};
}

}  // namespace candelabra
