// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/edited_file.h"

#include "syntax/contract_words.h"

#include <algorithm>
#include <iterator>

namespace candelabra {

namespace {

/// Returns the end of the comment that begins there; block comments nest.
std::size_t comment_end(std::string_view text, std::size_t first) {
    if (text.substr(first, 2) == "//") return std::min(text.find('\n', first), text.size());
    int depth = 0;
    for (std::size_t at = first; at < text.size(); ++at) {
        const std::string_view sign = text.substr(at, 2);
        if (sign != "/*" && sign != "*/") continue;
        depth += sign == "/*" ? 1 : -1;
        ++at;
        if (depth == 0) return at + 1;
    }
    return text.size();
}

/// Adds the comments between two tokens.
void read_comments(EditedFile& file, std::size_t first, std::size_t last) {
    for (std::size_t at = first; at + 1 < last; ++at) {
        const std::string_view sign = std::string_view(file.text).substr(at, 2);
        if (sign != "//" && sign != "/*") continue;
        const std::size_t end = comment_end(file.text, at);
        file.comments.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)});
        at = end - 1;
    }
}

/// Collects the names that directives declare.
class Declarations {
public:
    explicit Declarations(EditedFile& file) : file_(file) {}

    void operator()() {
        for (std::size_t i = 0; i < file_.tokens.size(); ++i) {
            const Token& token = file_.tokens[i];
            if (token.kind == TokenKind::hash_declare) declare(i + 1, token.value == 1);
            if (token.kind == TokenKind::hash_macro) macro(i + 1);
            if (token.kind == TokenKind::hash_fopen) add(i + 1, DeclaredName::file);
            if (token.kind == TokenKind::hash_for && is(i + 1, TokenKind::open_parenthesis))
                add(i + 2, DeclaredName::variable);
            if (token.kind == TokenKind::hash_read) list(i + 1, 1, DeclaredName::variable, false);
            if (token.kind == TokenKind::hash_include && is(i + 1, TokenKind::text))
                file_.includes.push_back(file_.values.texts[file_.tokens[i + 1].value]);
        }
    }

private:
    bool is(std::size_t i, TokenKind kind) const {
        return i < file_.tokens.size() && file_.tokens[i].kind == kind;
    }

    void add(std::size_t i, DeclaredName::Kind kind, bool local = false) {
        if (!is(i, TokenKind::name)) return;
        const Token& token = file_.tokens[i];
        file_.declarations.push_back({NameId(token.value), kind, local, {token.first, token.last}});
    }

    void declare(std::size_t i, bool local) {
        while (is(i, TokenKind::deprecated) || is(i, TokenKind::once) || is(i, TokenKind::text))
            ++i;
        if (is(i, TokenKind::open_parenthesis))
            list(i, 0, DeclaredName::variable, local);
        else
            add(i, DeclaredName::variable, local);
    }

    void macro(std::size_t i) {
        add(i, DeclaredName::macro);
        if (is(i + 1, TokenKind::open_parenthesis)) parameters(i + 2);
    }

    /// Adds the parameters of a macro, without `optional` and what they accept.
    void parameters(std::size_t i) {
        for (; i < file_.tokens.size() && !is(i, TokenKind::close_parenthesis); ++i) {
            const bool first =
                is(i - 1, TokenKind::comma) || is(i - 1, TokenKind::open_parenthesis);
            const bool bound = is(i - 1, TokenKind::less) || is(i - 1, TokenKind::less_equal) ||
                               is(i - 1, TokenKind::greater) || is(i - 1, TokenKind::greater_equal);
            const std::string_view word = spelling(i);
            if (bound || (!first && is_contract_word(word))) continue;
            if (word == "optional" && is(i + 1, TokenKind::name)) continue;
            add(i, DeclaredName::parameter, true);
        }
    }

    std::string_view spelling(std::size_t i) const {
        const Token& token = file_.tokens[i];
        return std::string_view(file_.text).substr(token.first, token.last - token.first);
    }

    /// Adds the names of a list in parentheses, except the first `without`.
    void list(std::size_t i, int without, DeclaredName::Kind kind, bool local) {
        if (!is(i, TokenKind::open_parenthesis)) return;
        for (++i; i < file_.tokens.size() && !is(i, TokenKind::close_parenthesis); ++i)
            if (is(i, TokenKind::name) && without-- <= 0) add(i, kind, local);
    }

    EditedFile& file_;
};

}  // namespace

const Token* EditedFile::token_at(std::uint32_t offset) const {
    const auto next = std::ranges::upper_bound(tokens, offset, {}, &Token::first);
    if (next == tokens.begin()) return nullptr;
    const Token& token = *std::prev(next);
    return offset <= token.last ? &token : nullptr;
}

EditedFile read_tokens(std::string text, Names& names) {
    EditedFile file;
    file.text = std::move(text);
    SourceStore sources;
    Diagnostics ignored;
    const SourceId source = sources.add("", file.text);
    Lexer lexer(source, sources, names, file.values, ignored);
    std::size_t end = 0;
    for (Token token = lexer.next();; token = lexer.next()) {
        const bool last = token.kind == TokenKind::end_of_file;
        read_comments(file, end, last ? file.text.size() : token.first);
        if (last) break;
        file.tokens.push_back(token);
        end = token.last;
    }
    Declarations{file}();
    return file;
}

}  // namespace candelabra
