// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/parser.h"

#include "grammar.h"
#include "syntax/parse_state.h"
#include "text/message.h"

#include <algorithm>
#include <array>

namespace {

using Parser = grammar::Parser;
using Kind = Parser::symbol_kind;

/// What could stand where an error is.
class Expected {
public:
    explicit Expected(const Parser::context& context) {
        count_ = static_cast<std::size_t>(
            context.expected_tokens(kinds_.data(), static_cast<int>(kinds_.size())));
    }

    bool has(Parser::symbol_kind_type kind) const {
        return std::find(kinds_.begin(), kinds_.begin() + static_cast<std::ptrdiff_t>(count_),
                         kind) != kinds_.begin() + static_cast<std::ptrdiff_t>(count_);
    }
    bool element() const {
        return has(Kind::S_OPEN_BRACKET) && has(Kind::S_DECLARE) && has(Kind::S_COLOUR_PREFIX);
    }
    bool value() const { return has(Kind::S_NUMBER); }
    bool comparison() const { return has(Kind::S_EQUAL) && has(Kind::S_GREATER); }
    bool name() const { return has(Kind::S_NAME) && !value(); }

    /// "`)` or a value"
    std::string list() const;

private:
    std::array<Parser::symbol_kind_type, Parser::YYNTOKENS> kinds_;
    std::size_t count_ = 0;
};

std::string Expected::list() const {
    std::vector<std::string> parts;
    if (value()) parts.push_back("a value");
    if (name()) parts.push_back("a name");
    if (has(Kind::S_TEXT) && !value()) parts.push_back("a string");
    constexpr auto signs =
        std::array{Kind::S_CLOSE_PARENTHESIS, Kind::S_CLOSE_BRACKET, Kind::S_CLOSE_BRACE,
                   Kind::S_HASH_END,          Kind::S_COLON,         Kind::S_COMMA};
    for (const auto sign : signs)
        if (has(sign)) parts.push_back(Parser::symbol_name(sign));
    if (has(Kind::S_GREATER) && !comparison()) parts.push_back("`>`");
    if (has(Kind::S_EQUAL) && !comparison()) parts.push_back("`=`");
    if (!value())
        for (const auto sign : {Kind::S_OPEN_PARENTHESIS, Kind::S_OPEN_BRACE})
            if (has(sign)) parts.push_back(Parser::symbol_name(sign));
    std::string result;
    for (std::size_t i = 0; i < parts.size(); ++i)
        result += (i == 0 ? "" : i + 1 == parts.size() ? " or " : ", ") + parts[i];
    return result;
}

std::string_view advice(Parser::symbol_kind_type found, const Expected& expected) {
    switch (found) {
        case Kind::S_LESS:
        case Kind::S_GREATER:
        case Kind::S_LESS_EQUAL:
        case Kind::S_GREATER_EQUAL:
        case Kind::S_NOT_EQUAL:
        case Kind::S_BOTH:
        case Kind::S_EITHER:
        case Kind::S_QUESTION:
            return "comparisons and conditions are written in parentheses: (a > b)";
        case Kind::S_EQUAL:
            return expected.element() ? "a name gets a value by `#declare Name = value;`"
                                      : "comparisons are written in parentheses: (a = b)";
        case Kind::S_COLOUR_PREFIX:
        case Kind::S_COLOUR:
        case Kind::S_CHANNEL:
            if (expected.name()) return {};
            return "a colour word stands before the whole value: rgb (A + B), not A + rgb B";
        case Kind::S_DIVIDE:
        case Kind::S_TIMES:
            return "an operator needs a value on both sides";
        default:
            return {};
    }
}

/// What people write who come from another language; `before` and `after` are the text around the
/// place.
std::string_view habit(Parser::symbol_kind_type found, const Expected& expected,
                       std::string_view before, std::string_view after) {
    constexpr std::string_view change = "a value is changed by `#declare I = I + 1;`";
    const auto letter = [](char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; };
    const std::string wanted = expected.list();
    if (before.ends_with("++") || before.ends_with("--")) return change;
    if (wanted == "`(`") return "a condition stands in parentheses: (a > b)";
    if (found == Kind::S_NUMBER && expected.name()) return "a name begins with a letter or `_`";
    if (wanted != "`=`") return {};
    if (after.size() > 1 && after[1] == '=') return change;
    if (after.starts_with('.'))
        return "parts of a vector are not set alone: #declare V = <2, V.y, V.z>;";
    const bool hyphen = after.starts_with('-') && after.size() > 1 && letter(after[1]);
    return hyphen ? "a name cannot have a `-`, but it can have a `_`" : "";
}

bool reserved_word(Parser::symbol_kind_type kind) {
    return kind >= Kind::S_WORD && kind <= Kind::S_CHANNEL && kind != Kind::S_NAME;
}

}  // namespace

void Parser::report_syntax_error(const context& context) const {
    const Span place = context.location();
    const symbol_kind_type found = context.token();
    // A token without text was put in by Brackets, which has reported what is missing.
    const bool mended = place.first == place.last && found != Kind::S_YYEOF;
    if (!mended) {
        const Expected expected(context);
        const std::string what =
            found == Kind::S_YYEOF
                ? "the end of the file"
                : message("`", state.text.substr(place.first, place.last - place.first), "`");
        std::string text = message("expected ", expected.list(), ", but found ", what);
        if (expected.element() || expected.list().empty())
            text = message(what, " does not fit here");
        if (expected.name() &&
            (reserved_word(found) || found == Kind::S_ARRAY || found == Kind::S_COLOUR))
            text = message(what,
                           " is a word of the language and cannot be the name of something else");
        Diagnostic problem = ::error(Fault::syntax, place, text);
        if (expected.has(Kind::S_GREATER) && !expected.comparison())
            problem.with_help(
                "a vector ends in `>`; comparisons are written in parentheses: (a < b)");
        if (const std::string_view help = advice(found, expected); !help.empty())
            problem.with_help(std::string(help));
        if (const std::string_view help = habit(found, expected, state.text.substr(0, place.first),
                                                state.text.substr(place.first));
            !help.empty())
            problem.with_help(std::string(help));
        if (const auto open = state.brackets.innermost();
            open && open->first != place.first && !expected.element() && !expected.name() &&
            (expected.has(Kind::S_CLOSE_PARENTHESIS) || expected.has(Kind::S_CLOSE_BRACKET)))
            problem.pointing(*open, "opened here");
        state.diagnostics.add(problem);
    }
    state.brackets.recover();
}

void Parser::error(const Span&, const std::string&) {}

/// Data files consist of plain vectors with commas between them: to the grammar, those that end in
/// a comma are one token. Its last comma, or nothing when there is not even one of them.
static std::optional<Token> take_row(Token vector, ParseState& state, List& row) {
    std::optional<Token> end;
    for (;;) {
        const Token comma = state.brackets.next();
        if (comma.kind != TokenKind::comma) {
            state.brackets.put_back(comma, vector);
            if (end) state.brackets.put_back(vector, *end);
            return end;
        }
        row = state.append(row, state.add({state.tree.source, vector.first, vector.last},
                                          node::Literal{vector.value, vector.count}));
        row.comma = true;
        end = comma;
        vector = state.brackets.next();
        if (vector.kind != TokenKind::literal) {
            state.brackets.put_back(vector, comma);
            return end;
        }
    }
}

int yylex(SemanticValue* value, Span* place, ParseState& state) {
    const bool may_begin_row = state.brackets.begins_item();
    const Token token = state.brackets.next();
    if (may_begin_row && token.kind == TokenKind::literal) {
        List row;
        if (const auto end = take_row(token, state, row)) {
            *place = {state.tree.source, token.first, end->last};
            value->list = row;
            return Parser::token::ROW;
        }
    }
    *place = {state.tree.source, token.first, token.last};
    switch (token.kind) {
        case TokenKind::end_of_file:
            return 0;
        case TokenKind::name:
        case TokenKind::word:
        case TokenKind::layer:
        case TokenKind::constant:
        case TokenKind::unary_function:
        case TokenKind::function:
        case TokenKind::colour_prefix:
        case TokenKind::channel:
            value->name = NameId(token.value);
            break;
        case TokenKind::literal:
            value->literal = {token.value, token.count};
            break;
        default:
            value->number = token.value;
    }
    // The grammar's tokens are TokenKind's, after the end, the error token and the undefined token.
    return static_cast<int>(token.kind) + 2;
}

static_assert(Parser::token::WRITE == static_cast<int>(TokenKind::hash_write) + 2);
static_assert(Parser::token::SEMICOLON == static_cast<int>(TokenKind::semicolon) + 2);

Tree parse(SourceId source, const SourceStore& sources, Names& names, Diagnostics& diagnostics) {
    Tree tree;
    tree.source = source;
    const std::string_view text = sources.text(source);
    // Most of a long file is numbers: about one node for twenty bytes. Not reserving more keeps
    // small files small.
    tree.nodes.reserve(text.size() / 20 + 16);
    Lexer lexer(source, sources, names, tree, diagnostics);
    Brackets brackets(lexer, source, text, diagnostics);
    ParseState state{tree, names, brackets, diagnostics, text};
    Parser(state).parse();
    return tree;
}
