// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/parser.h"

#include "grammar.h"
#include "syntax/foreign.h"
#include "syntax/parse_state.h"
#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <utility>

namespace candelabra {

namespace {

/// The tokens that could stand in place of an error.
class Expected {
public:
    explicit Expected(const TokenKinds& kinds) : kinds_(kinds) {}

    bool has(TokenKind kind) const { return kinds_.test(static_cast<std::size_t>(kind)); }
    bool element() const {
        return has(TokenKind::open_bracket) && has(TokenKind::hash_declare) &&
               has(TokenKind::colour_prefix);
    }
    bool value() const { return has(TokenKind::number); }
    bool comparison() const { return has(TokenKind::equal) && has(TokenKind::greater); }
    /// A member, after a `.`.
    bool member() const { return has(TokenKind::channel) && !value() && !element(); }
    bool name() const { return has(TokenKind::name) && !value() && !member(); }

    /// The expected tokens in words: "`)` or a value".
    std::string list() const;

private:
    TokenKinds kinds_;
};

struct Sign {
    TokenKind kind;
    const char* written;
};

std::string Expected::list() const {
    using enum TokenKind;
    constexpr auto closing = std::array{
        Sign{close_parenthesis, "`)`"}, Sign{close_bracket, "`]`"}, Sign{close_brace, "`}`"},
        Sign{hash_end, "`#end`"},       Sign{colon, "`:`"},         Sign{comma, "`,`"}};
    constexpr auto opening = std::array{Sign{open_parenthesis, "`(`"}, Sign{open_brace, "`{`"}};
    std::vector<std::string> parts;
    const auto add = [&](std::span<const Sign> signs) {
        for (const Sign& sign : signs)
            if (has(sign.kind)) parts.push_back(sign.written);
    };
    if (value()) parts.push_back("a value");
    if (this->name()) parts.push_back("a name");
    if (member()) parts.push_back("a part of a vector or a colour");
    if (has(text) && !value()) parts.push_back("a string");
    add(closing);
    if (has(greater) && !comparison()) parts.push_back("`>`");
    if (has(equal) && !comparison()) parts.push_back("`=`");
    if (!value()) add(opening);
    std::string result;
    for (std::size_t i = 0; i < parts.size(); ++i)
        result += (i == 0 ? "" : i + 1 == parts.size() ? " or " : ", ") + parts[i];
    return result;
}

std::string_view advice(TokenKind found, const Expected& expected) {
    switch (found) {
        case TokenKind::less:
        case TokenKind::greater:
        case TokenKind::less_equal:
        case TokenKind::greater_equal:
        case TokenKind::not_equal:
        case TokenKind::both:
        case TokenKind::either:
        case TokenKind::question:
            if (found == TokenKind::either && expected.value() && !expected.element())
                return "the size of a number without its sign is abs(X), of a vector vlength(V)";
            return "comparisons and conditions are written in parentheses: (a > b)";
        case TokenKind::equal:
            if (expected.name()) return "the name comes before the `=`: #declare Name = value;";
            return expected.element() ? "a name gets a value by `#declare Name = value;`"
                                      : "comparisons are written in parentheses: (a = b)";
        case TokenKind::colour_prefix:
        case TokenKind::colour:
        case TokenKind::channel:
            if (expected.name()) return {};
            return "a colour word stands before the whole value: rgb (A + B), not A + rgb B";
        case TokenKind::comma:
            return expected.has(TokenKind::close_bracket) && !expected.element()
                       ? "each index has its own brackets: A[1][2]"
                       : "";
        case TokenKind::divide:
        case TokenKind::times:
            return "an operator needs a value on both sides";
        case TokenKind::hash_end:
        case TokenKind::hash_else:
        case TokenKind::hash_elseif:
            if (!expected.value()) return {};
            return "an operator and the value behind it stand in the same part of a directive: "
                   "1 #if (A) + 2 #end";
        default:
            return {};
    }
}

/// Help for a directive that lacks a parenthesis after its word, at the end of the text.
std::string_view in_parentheses(std::string_view before) {
    const std::string_view word = before.substr(std::min(before.rfind('#'), before.size()));
    if (word.starts_with("#ifdef") || word.starts_with("#ifndef"))
        return "the name stands in parentheses: #ifdef (Name)";
    if (word.starts_with("#for")) return "a loop counts in parentheses: #for (I, 1, 10)";
    if (word.starts_with("#macro")) return "parameters stand in parentheses: #macro Name(A, B)";
    if (word.starts_with("#switch") || word.starts_with("#case"))
        return "what is looked at stands in parentheses: #switch (A) #case (1)";
    if (word == "#write") return "what is written stands in parentheses: #write (File, A, \"\\n\")";
    if (word == "#read") return "what is read stands in parentheses: #read (File, A, B)";
    if (word.find_first_of(" \t\r\n") == word.npos && word.starts_with('#'))
        return "a condition stands in parentheses: (a > b)";
    return {};
}

std::string_view without_blanks(std::string_view before) {
    return before.substr(0, before.find_last_not_of(" \t\r\n") + 1);
}

/// The word at the end of the text.
std::string_view last_word(std::string_view text) {
    std::size_t first = text.size();
    while (first > 0 && in_name(text[first - 1])) --first;
    return text.substr(first);
}

bool reserved_word(TokenKind kind) {
    return kind >= TokenKind::word && kind <= TokenKind::channel && kind != TokenKind::name;
}

/// Help for a mistake in the directive read so far.
std::string_view directive_habit(TokenKind found, const Expected& expected,
                                 std::string_view directive) {
    if (directive == "#fclose") return "the name that #fopen gave the file: #fclose File";
    if (directive.starts_with("#fopen") && directive.find('"') != directive.npos && expected.name())
        return "what the file is for comes last: #fopen File \"data.txt\" read, or write, or "
               "append";
    if (directive.starts_with("#case") && found == TokenKind::comma)
        return "each value has its own case, and a range is #range (1, 2)";
    const bool declares = directive.starts_with("#declare") || directive.starts_with("#local");
    if (declares && found == TokenKind::equal && !expected.name() &&
        directive.find_first_of(";{\n") == directive.npos && directive.find('=') != directive.npos)
        return "each name has its own #declare: #declare A = 1; #declare B = 1;";
    if (directive.starts_with("#range") && expected.has(TokenKind::comma))
        return "a range has two ends: #range (1, 2)";
    return {};
}

/// Help for phrases of other languages; `before` and `after` are the text around the place.
std::string habit(TokenKind found, const Expected& expected, std::string_view before,
                  std::string_view after) {
    constexpr std::string_view change = "a value is changed by `#declare I = I + 1;`";
    const std::string wanted = expected.list();
    if (before.ends_with("++") || before.ends_with("--")) return std::string(change);
    before = without_blanks(before);
    if (const auto help = foreign_words(before, after); !help.empty()) return std::string(help);
    if (found == TokenKind::greater && before.ends_with('>')) return "one `>` ends the vector";
    if (found == TokenKind::greater && before.ends_with('<')) return "`!=` is not equal: (a != b)";
    if (found == TokenKind::greater && before.ends_with('='))
        return "`>=` is greater or equal: (a >= b)";
    if (found == TokenKind::times && before.ends_with('*')) return "a power is pow(base, exponent)";
    if (expected.member())
        return "parts are x y z t, u v, red green blue filter transmit, gray: V.x";
    if (expected.value() && ends_in_word(before, "end"))
        return "a part of the directive before it ends in an operator, so a value follows: "
               "#if (A) 2 * #end 3";
    const std::string_view directive = before.substr(std::min(before.rfind('#'), before.size()));
    if (found == TokenKind::text && directive == "#fopen")
        return "the name of the open file comes first: #fopen File \"data.txt\" write";
    if (const auto help = directive_habit(found, expected, directive); !help.empty())
        return std::string(help);
    if (found == TokenKind::colon)
        if (const auto help = foreign_colon(before); !help.empty()) return std::string(help);
    const bool sum = before.ends_with('-') || before.ends_with('+') || before.ends_with('*');
    if (sum && reserved_word(found) &&
        without_blanks(before.substr(0, before.size() - 1)).ends_with('}'))
        return "objects are joined by blocks: difference { A B }, union { A B }";
    const bool no_comma = found == TokenKind::equal || found == TokenKind::semicolon;
    if (no_comma && directive.starts_with("#for"))
        return "a loop counts between commas: #for (I, 1, 10)";
    if (found == TokenKind::equal && directive.starts_with("#macro"))
        return "a parameter that may be left out: "
               "#macro M(A, optional B) #ifndef (B) #local B = 2; #end ... #end";
    if (directive == "#default")
        return after.starts_with("texture") || after.starts_with("pigment") ||
                       after.starts_with("finish")
                   ? "defaults stand in braces: #default { texture { ... } }"
                   : "the last part of a #switch is `#else`";
    const bool bracket = found == TokenKind::open_brace || found == TokenKind::open_bracket;
    if (bracket && expected.value() && before.ends_with('='))
        return "an array is written array { 1, 2, 3 }";
    if (wanted == "`(`") {
        if (const auto help = in_parentheses(before); !help.empty()) return std::string(help);
        return message("the arguments of a function stand in parentheses: ", last_word(before),
                       "(...)");
    }
    if (found == TokenKind::semicolon && wanted == "`}`")
        return "a function is one expression, without `;`";
    if (found == TokenKind::number && expected.name()) return "a name begins with a letter or `_`";
    if (wanted != "`=`") return {};
    if (after.starts_with(":=")) return "a name gets its value by `=` alone: #declare A = 1;";
    if (after.size() > 1 && after[1] == '=') return std::string(change);
    if (found == TokenKind::semicolon) return "a name is declared with its value: #declare A = 0;";
    if (after.starts_with('.'))
        return "parts of a vector are not set alone: #declare V = <2, V.y, V.z>;";
    if (after.starts_with('('))
        return "a function is written #declare F = function(X) { ... };, and what gives other than "
               "numbers is a macro";
    const bool hyphen = after.starts_with('-') && after.size() > 1 && is_letter(after[1]);
    return hyphen ? "a name cannot have a `-`, but it can have a `_`" : "";
}

/// Whether the token is `&&`, `||` or `==`, which the lexer has reported.
bool doubled(TokenKind kind, Stretch place) {
    using enum TokenKind;
    return (kind == both || kind == either || kind == equal) && place.last - place.first == 2;
}

std::string capitalised(std::string_view word) {
    std::string result(word);
    if (result[0] >= 'a' && result[0] <= 'z') result[0] = static_cast<char>(result[0] - 'a' + 'A');
    return result;
}

}  // namespace

void ParseState::report_unexpected(TokenKind found, Stretch place, const TokenKinds& kinds) const {
    // A token without text was inserted by Brackets, which has reported the missing one.
    const bool mended = place.first == place.last && found != TokenKind::end_of_file;
    const Expected expected(kinds);
    // The braces of a function hold one expression, so a word after it means that `}` is missing.
    const bool closer_missing = expected.has(TokenKind::close_brace) && !expected.element() &&
                                !expected.value() && reserved_word(found);
    if (!mended && !doubled(found, place)) {
        const std::string what =
            found == TokenKind::end_of_file
                ? "the end of the file"
                : message("`", text.substr(place.first, place.last - place.first), "`");
        std::string says = message("expected ", expected.list(), ", but found ", what);
        if (expected.element() || expected.list().empty())
            says = message(what, " does not fit here");
        const bool reserved =
            reserved_word(found) || found == TokenKind::array || found == TokenKind::colour;
        if (expected.name() && reserved)
            says = message(what,
                           " is a word of the language and cannot be the name of something else");
        Diagnostic problem = candelabra::error(Fault::syntax, span(place), says);
        if (expected.has(TokenKind::greater) && !expected.comparison())
            problem.with_help(
                "a vector ends in `>`; comparisons are written in parentheses: (a < b)");
        std::string help =
            habit(found, expected, text.substr(0, place.first), text.substr(place.first));
        if (help.empty()) help = advice(found, expected);
        if (help.empty() && expected.name() && reserved)
            help = message("names with a capital letter are always free: `",
                           capitalised(text.substr(place.first, place.last - place.first)), "`");
        if (help.empty() && closer_missing) help = "add the missing `}`";
        if (!help.empty()) problem.with_help(std::move(help));
        const auto open = brackets.innermost();
        if (found == TokenKind::equal && expected.element() && open && text[open->first] == '{')
            problem.with_help("the words of a block have no `=`: radius 2");
        if (open && open->first != place.first && !expected.element() && !expected.name() &&
            (expected.has(TokenKind::close_parenthesis) || expected.has(TokenKind::close_bracket) ||
             closer_missing))
            problem.pointing(*open, "opened here");
        diagnostics.add(problem);
    }
    brackets.recover(closer_missing);
}

/// Data files consist of plain vectors with commas between them. A run of vectors that each end in
/// a comma is one token to the grammar. Appends them to `row` and returns the last comma, or
/// nothing if there is no such vector.
static std::optional<Token> take_row(Token vector, ParseState& state, List& row) {
    std::optional<Token> end;
    for (;;) {
        const Token comma = state.brackets.next();
        if (comma.kind != TokenKind::comma) {
            state.brackets.put_back(comma, vector);
            if (end) state.brackets.put_back(vector, *end);
            return end;
        }
        row = state.append(
            row, state.add({vector.first, vector.last}, node::Literal{vector.value, vector.count}));
        row = row.with_comma(true);
        end = comma;
        vector = state.brackets.next();
        if (vector.kind != TokenKind::literal) {
            state.brackets.put_back(vector, comma);
            return end;
        }
    }
}

int grammar_lex(SemanticValue* value, Stretch* place, ParseState& state) {
    const bool may_begin_row = state.brackets.begins_item();
    const Token token = state.brackets.next();
    if (may_begin_row && token.kind == TokenKind::literal) {
        List row;
        if (const auto end = take_row(token, state, row)) {
            *place = {token.first, end->last};
            value->list = row;
            return TOKEN_ROW;
        }
    }
    *place = {token.first, token.last};
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
            value->literal = node::Literal{token.value, token.count};
            break;
        default:
            value->number = token.value;
    }
    return static_cast<int>(token.kind) + 2;
}

static_assert(TOKEN_WRITE == static_cast<int>(TokenKind::hash_write) + 2);
static_assert(TOKEN_SEMICOLON == static_cast<int>(TokenKind::semicolon) + 2);

namespace {

/// The result of parsing a text once.
struct Pass {
    Tree tree;
    Diagnostics found;
    bool early = false;  ///< an open macro was called before it was known
};

Pass parse_once(SourceId source, const SourceStore& sources, Names& names,
                const ParseOptions& options, Diagnostics found) {
    Pass pass{{}, std::move(found)};
    Tree& tree = pass.tree;
    tree.source = source;
    const std::string_view text = sources.text(source);
    // Enough nodes for most texts; very long texts are numbers, one in twenty bytes.
    constexpr std::size_t long_text = 4'000'000;
    tree.nodes.reserve(std::min(text.size(), long_text) / 4 + text.size() / 20 + 16);
    Lexer lexer(source, sources, names, tree, pass.found, options.version);
    OpenMacros macros(names, tree, pass.found, *options.macros, options.reader);
    Brackets brackets(lexer, macros, options.version, source, text, pass.found);
    ParseState state{tree, names, brackets, pass.found, text, options.postpones};
    grammar_parse(state);
    if (!options.included) macros.report_idle();
    pass.early = macros.called_too_early();
    return pass;
}

}  // namespace

Tree parse(SourceId source, const SourceStore& sources, Names& names, Diagnostics& diagnostics,
           const ParseOptions& given) {
    ParseOptions options = given;
    OpenMacroList own;
    if (!options.macros) options.macros = &own;
    std::set<NameId> known;
    const auto learns = [&] {
        const std::size_t before = known.size();
        for (const auto& each : *options.macros) known.insert(each->name);
        return known.size() > before;
    };
    const auto once = [&] {
        return parse_once(source, sources, names, options, diagnostics.fresh());
    };
    learns();
    Pass best = once();
    bool early = best.early;
    // Each pass finds macros open that call macros found open in the pass before. If none of them
    // is new, another pass would give the same tree.
    constexpr int most = 100;
    for (int times = 1; early && times < most && learns(); ++times) {
        Pass pass = once();
        early = pass.early;
        if (!pass.found.failed()) best = std::move(pass);
    }
    diagnostics.add_all(best.found);
    return std::move(best.tree);
}

}  // namespace candelabra
