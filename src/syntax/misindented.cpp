// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/misindented.h"

#include "syntax/lexer.h"
#include "syntax/token_classes.h"

#include <string>
#include <vector>

namespace candelabra {

std::optional<Misindented> misindented(std::string_view text, bool directives) {
    const auto indentation = [&](std::uint32_t at, bool only_blanks) -> int {
        const std::size_t start = at == 0 ? 0 : text.find_last_of("\r\n", at - 1) + 1;
        const std::size_t word = text.find_first_not_of(" \t", start);
        return only_blanks && word != at ? -1 : static_cast<int>(word - start);
    };
    const auto is_opener = [&](TokenKind kind) {
        return directives ? opens_directive(kind) : kind == TokenKind::open_brace;
    };
    const TokenKind closer = directives ? TokenKind::hash_end : TokenKind::close_brace;
    std::vector<Token> openers;
    SourceStore copy;
    const SourceId id = copy.add("", std::string(text));
    Names names;
    Tree tree;
    Diagnostics ignored;
    Lexer lexer(id, copy, names, tree, ignored);
    for (Token token = lexer.next(); token.kind != TokenKind::end_of_file; token = lexer.next()) {
        if (is_opener(token.kind)) openers.push_back(token);
        if (token.kind != closer || openers.empty()) continue;
        const int here = indentation(token.first, true);
        if (here >= 0 && here < indentation(openers.back().first, false))
            return Misindented{openers.back(), token};
        openers.pop_back();
    }
    return std::nullopt;
}

}  // namespace candelabra
