// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/foreign.h"

#include "syntax/lexer.h"
#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

struct ForeignWord {
    std::string_view word, meant;
};

constexpr auto directives = std::array{
    ForeignWord{"set", "declare"},    ForeignWord{"let", "declare"},
    ForeignWord{"var", "declare"},    ForeignWord{"const", "declare"},
    ForeignWord{"print", "debug"},    ForeignWord{"echo", "debug"},
    ForeignWord{"import", "include"}, ForeignWord{"use", "include"},
    ForeignWord{"endif", "end"},      ForeignWord{"endwhile", "end"},
    ForeignWord{"endfor", "end"},     ForeignWord{"endmacro", "end"},
    ForeignWord{"endswitch", "end"},  ForeignWord{"function", "macro"},
    ForeignWord{"next", "end"},       ForeignWord{"done", "end"},
    ForeignWord{"define", "declare"}, ForeignWord{"assign", "declare"},
    ForeignWord{"foreach", "for"},    ForeignWord{"elsif", "elseif"},
};

struct ForeignName {
    std::string_view name, way_out;
};

constexpr auto foreign_names = std::array{
    ForeignName{"return", "a macro needs no `return`: it gives what stands in it"},
    ForeignName{"rgba", "write `rgbt <red, green, blue, transmit>`, with 1 - alpha as transmit"},
    ForeignName{"null", "a name that is not declared has no value: #ifdef (Name)"},
    ForeignName{"length",
                "the length of a string is strlen(S), of a vector vlength(V), of an array "
                "dimension_size(A, 1)"},
    ForeignName{"len",
                "the length of a string is strlen(S), of a vector vlength(V), of an array "
                "dimension_size(A, 1)"},
    ForeignName{"round",
                "int(X + 0.5) rounds what is not negative; floor and ceil round down and "
                "up"},
    ForeignName{"sqr", "a square is X*X, or pow(X, 2)"},
    ForeignName{"random", "random numbers come from a stream: #declare S = seed(1); ... rand(S)"},
    ForeignName{"this", "a macro gets what it works on as a parameter"},
    ForeignName{"print", "#debug \"...\\n\" prints a string"},
    ForeignName{"printf",
                "#debug concat(\"N = \", str(N, 0, 2), \"\\n\") prints a string and a number"},
    ForeignName{"echo", "#debug \"...\\n\" prints a string"},
    ForeignName{"None", "a name that is not declared has no value: #ifdef (Name)"},
    ForeignName{"nil", "a name that is not declared has no value: #ifdef (Name)"},
    ForeignName{"then", "an #if needs no `then`: #if (A) ... #else ... #end"},
    ForeignName{"do", "a loop is written #while (A) ... #end"},
    ForeignName{"begin", "a directive needs no `begin`: #if (A) ... #end"},
    ForeignName{"brightness", "a light is as bright as its colour: rgb 2"},
    ForeignName{"transparency", "what is half clear has a colour like rgbt <1, 0, 0, 0.5>"},
    ForeignName{"halo", "POV-Ray 3.1 replaced it by `media`: hollow interior { media { ... } }"},
    ForeignName{"atmosphere", "POV-Ray 3.1 replaced it by `media`: media { scattering { ... } }"},
};

constexpr auto block_words = std::array{
    ForeignWord{"jpg", "jpeg"},
    ForeignWord{"tif", "tiff"},
    ForeignWord{"position", "location"},
    ForeignWord{"eye", "location"},
    ForeignWord{"fov", "angle"},
    ForeignWord{"move", "translate"},
    ForeignWord{"opacity", "transmit"},
    ForeignWord{"shininess", "phong_size"},
    ForeignWord{"reflectivity", "reflection"},
    ForeignWord{"metalness", "metallic"},
    ForeignWord{"emissive", "emission"},
    ForeignWord{"glow", "emission"},
    ForeignWord{"bump", "normal"},
    ForeignWord{"target", "look_at"},
    ForeignWord{"target", "point_at"},
};

constexpr auto signs = std::array{
    ForeignSign{"\u201C", "a typographic quote", "\""},
    ForeignSign{"\u201D", "a typographic quote", "\""},
    ForeignSign{"\u201E", "a typographic quote", "\""},
    ForeignSign{"\u00AB", "a typographic quote", "\""},
    ForeignSign{"\u00BB", "a typographic quote", "\""},
    ForeignSign{"\u2018", "a typographic quote", "\""},
    ForeignSign{"\u2019", "a typographic quote", "\""},
    ForeignSign{"\u2010", "a hyphen", "-"},
    ForeignSign{"\u2011", "a hyphen", "-"},
    ForeignSign{"\u2013", "a dash", "-"},
    ForeignSign{"\u2014", "a dash", "-"},
    ForeignSign{"\u2212", "a minus sign beyond ASCII", "-"},
    ForeignSign{"\u00D7", "a multiplication sign", "*"},
    ForeignSign{"\u00B7", "a multiplication sign", "*"},
    ForeignSign{"\u00F7", "a division sign", "/"},
    ForeignSign{"\u00B0", "a degree sign, and angles are in degrees", "", true},
    ForeignSign{"\uFF0C", "a wide comma", ","},
    ForeignSign{"\u3001", "a wide comma", ","},
    ForeignSign{"\uFF1B", "a wide semicolon", ";"},
    ForeignSign{"\uFF08", "a wide parenthesis", "("},
    ForeignSign{"\uFF09", "a wide parenthesis", ")"},
    ForeignSign{"\uFF1D", "a wide equals sign", "="},
    ForeignSign{"\uFF0B", "a wide plus sign", "+"},
    ForeignSign{"'", "a single quote", "\""},
    ForeignSign{"\u00B2", "a sign for a square, which is written X*X", ""},
    ForeignSign{"\u00B3", "a sign for a cube, which is written pow(X, 3)", ""},
    ForeignSign{"\u221A", "a sign for a root, which is written sqrt(X)", ""},
    ForeignSign{"\u03C0", "a Greek letter", "pi"},
    ForeignSign{"\u2264", "a sign beyond ASCII", "<="},
    ForeignSign{"\u2265", "a sign beyond ASCII", ">="},
    ForeignSign{"\u2260", "a sign beyond ASCII", "!="},
    ForeignSign{"\u00A0", "a no-break space", " "},
    ForeignSign{"\u2009", "a thin space", " "},
    ForeignSign{"\u202F", "a narrow space", " "},
    ForeignSign{"\u200B", "a space without width", " "},
    ForeignSign{"\u3000", "a wide space", " "},
    ForeignSign{"\uFEFF", "a byte order mark", " "},
};

/// Red, green and blue, 0 to 255, from six hexadecimal digits; nothing for other words.
std::optional<std::array<unsigned, 3>> hexadecimal_channels(std::string_view word) {
    constexpr std::size_t digits = 6;
    unsigned value = 0;
    const char* const end = word.data() + word.size();
    if (word.size() != digits || std::from_chars(word.data(), end, value, 16).ptr != end)
        return std::nullopt;
    return std::array{value >> 16, value >> 8 & 255, value & 255};
}

}  // namespace

const ForeignSign* foreign_sign(std::string_view text) {
    for (const ForeignSign& each : signs)
        if (text.starts_with(each.sign)) return &each;
    return nullptr;
}

std::string_view foreign_directive(std::string_view word) {
    for (const ForeignWord& each : directives)
        if (each.word == word) return each.meant;
    return {};
}

std::string_view foreign_name(std::string_view name) {
    const auto found = std::ranges::find(foreign_names, name, &ForeignName::name);
    return found == foreign_names.end() ? std::string_view() : found->way_out;
}

std::vector<std::string_view> foreign_word(std::string_view word) {
    std::vector<std::string_view> result;
    for (const ForeignWord& each : block_words)
        if (each.word == word) result.push_back(each.meant);
    return result;
}

std::string meant_as_file(std::string_view text, Span name) {
    constexpr auto endings = std::array<std::string_view, 22>{
        "png", "jpg", "jpeg", "gif", "tga", "iff", "tif", "tiff", "bmp", "ppm", "pgm",
        "pot", "sys", "exr",  "hdr", "df3", "ttf", "otf", "csv",  "inc", "obj", "ply"};
    const std::string_view spelling = text.substr(name.first, name.last - name.first);
    const std::string_view behind = text.substr(name.last);
    if (behind.starts_with('.')) {
        std::size_t end = 1;
        while (end < behind.size() && in_name(behind[end])) ++end;
        const std::string_view ending = behind.substr(1, end - 1);
        const auto is_one = [&](std::string_view each) { return same_letters(each, ending); };
        if (std::ranges::any_of(endings, is_one)) return message(spelling, '.', ending);
    }
    // The kind of a file before the name.
    std::string_view before = text.substr(0, name.first);
    before = before.substr(0, before.find_last_not_of(" \t\r\n") + 1);
    const auto stands_before = [&](std::string_view each) { return ends_in_word(before, each); };
    return std::ranges::any_of(endings, stands_before) ? std::string(spelling) : "";
}

std::string hexadecimal_colour(std::string_view word) {
    const auto channels = hexadecimal_channels(word);
    if (!channels) return {};
    const auto [red, green, blue] = *channels;
    return message("srgb <", red, ", ", green, ", ", blue, ">/255");
}

std::string_view foreign_words(std::string_view before, std::string_view after) {
    if (ends_in_word(before, "not")) return "`not` is written as a sign: (!A)";
    if (ends_in_word(before, "return"))
        return "a function needs no `return`: function(X) { X*2 } gives what its expression gives";
    if (begins_with_word(after, "and")) return "`and` is written as a sign: (A & B)";
    if (begins_with_word(after, "or")) return "`or` is written as a sign: (A | B)";
    if (begins_with_word(after, "mod")) return "the remainder of a division is mod(A, B)";
    for (const std::string_view channel : {"red", "green", "blue"})
        if (ends_in_word(before, channel))
            return "red, green and blue are channels, and need a number; colors.inc declares the "
                   "colours Red, Green and Blue";
    return {};
}

std::string_view foreign_colon(std::string_view before) {
    const std::string_view line = before.substr(before.find_last_of("\r\n") + 1);
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != line.npos && begins_with_word(line.substr(first), "def"))
        return "a macro is written #macro Name(A, B) ... #end";
    constexpr auto conditions =
        std::array<std::string_view, 5>{"#if", "#elseif", "#while", "#for", "#switch"};
    for (const std::string_view word : conditions)
        if (first != line.npos && begins_with_word(line.substr(first), word))
            return "no `:` stands behind a condition";
    return before.ends_with("\"]") ? "dictionaries are not available in this version" : "";
}

// ---- how the lexer handles them

void Lexer::report_missing_hash(const char* first, std::string_view word) {
    report(warning(Fault::deprecated, span(first, cursor_),
                   message("`", word, "` should have a # before it"))
               .with_help(message("write `#", word, "`")));
}

/// Consumes and reports the `if` of `#else if`, as other languages write it. False if none follows.
bool Lexer::takes_if(const char* hash) {
    const char* p = cursor_;
    while (p < limit_ && (*p == ' ' || *p == '\t')) ++p;
    if (!begins_with_word({p, static_cast<std::size_t>(limit_ - p)}, "if")) return false;
    cursor_ = p + 2;
    report(error(Fault::syntax, span(hash, cursor_), "`#else if` is one word")
               .with_help("write `#elseif`, which has the `#end` of its `#if`"));
    return true;
}

/// Whether the word belongs to `#end`, as in `#end if` of other languages; if so, it is reported.
/// `#end if (A)` may begin another directive.
bool Lexer::stands_behind_end(const char* first, std::string_view word) {
    const char* p = first;
    while (p > begin_ && (p[-1] == ' ' || p[-1] == '\t')) --p;
    if (previous_ != TokenKind::hash_end || p == first || !is_letter(p[-1])) return false;
    const std::size_t behind = rest().find_first_not_of(" \t");
    if (behind != std::string_view::npos && rest()[behind] == '(') return false;
    report(error(Fault::syntax, span(first, cursor_),
                 message("`#end` ends any directive, and no `", word, "` follows it"))
               .with_help("write `#end`"));
    return true;
}

/// Skips `# words of a comment`, as other languages write it: more than one word must be on the
/// line. The first may contain an apostrophe, letters beyond ASCII or a comma.
bool Lexer::takes_comment() {
    const auto goes_on = [](char c) {
        return is_letter(c) || (static_cast<unsigned char>(c) & 0x80) ||
               std::string_view("',.:!?-").find(c) != std::string_view::npos;
    };
    const char* p = cursor_;
    while (p < limit_ && goes_on(*p)) ++p;
    const char* const end = p;
    while (p < limit_ && (*p == ' ' || *p == '\t')) ++p;
    if (p == end || p == limit_ || !is_letter(*p)) return false;
    skip_line_comment();
    return true;
}

void Lexer::second_point(const char* first) {
    Diagnostic problem = error(Fault::syntax, span(first, cursor_), "a number has only one point");
    if (std::string_view(first, cursor_).find("..") != std::string_view::npos)
        problem.with_help("from one number to another is written with a comma: #for (I, 0, 9)");
    report(problem);
}

/// Reads a colour as web pages write it: as a vector where a colour is expected, else as nothing.
Token Lexer::read_hexadecimal_colour(const char* hash, std::string_view word) {
    const auto channels = hexadecimal_channels(word);
    const bool wanted = previous_ == TokenKind::colour || previous_ == TokenKind::colour_prefix;
    if (!wanted || !channels) return scan();
    Token result =
        token(TokenKind::literal, hash, static_cast<std::uint32_t>(tree_.numbers.size()));
    for (const unsigned channel : *channels) tree_.numbers.push_back(channel / 255.0);
    result.count = 3;
    return result;
}

bool Lexer::between_values() const {
    using enum TokenKind;
    constexpr auto ends =
        std::array{name, constant, number, literal, channel, close_parenthesis, close_bracket};
    const char* p = cursor_;
    while (p < limit_ && (*p == ' ' || *p == '\t')) ++p;
    const bool begins =
        p < limit_ && (in_name(*p) || std::string_view("(.<+-").find(*p) != std::string_view::npos);
    return begins && std::ranges::find(ends, previous_) != ends.end();
}

std::optional<Token> Lexer::read_foreign_sign(const char* first, const ForeignSign& sign) {
    using enum TokenKind;
    cursor_ += sign.sign.size();
    report(error(Fault::unknown_character, span(first, cursor_), message("this is ", sign.what))
               .with_help(sign.meant == " "    ? "write an ordinary blank"
                          : sign.needless      ? "leave it out"
                          : sign.meant.empty() ? ""
                                               : message("write `", sign.meant, "`")));
    constexpr auto tokens = std::array{
        std::pair{"-", minus},
        std::pair{"*", times},
        std::pair{"/", divide},
        std::pair{"<=", less_equal},
        std::pair{">=", greater_equal},
        std::pair{"!=", not_equal},
        std::pair{",", comma},
        std::pair{";", semicolon},
        std::pair{"(", open_parenthesis},
        std::pair{")", close_parenthesis},
        std::pair{"=", equal},
        std::pair{"+", plus},
    };
    for (const auto& [meant, kind] : tokens)
        if (sign.meant == meant) return token(kind, first);
    if (sign.meant == "pi")
        return token(constant, first, static_cast<std::uint32_t>(names_.intern("pi")));
    // Text that is passed over may contain apostrophes.
    if (sign.meant.empty() || sign.meant == " " || quiet_) return std::nullopt;
    // The string ends at the next quote, if that is on the same line.
    for (const char* p = cursor_; p < limit_ && *p != '\n' && *p != '\r'; ++p) {
        const ForeignSign* end = foreign_sign({p, static_cast<std::size_t>(limit_ - p)});
        if (*p != '"' && !(end && end->meant == "\"")) continue;
        tree_.texts.emplace_back(cursor_, p);
        cursor_ = p + (end ? end->sign.size() : 1);
        return token(text, first, static_cast<std::uint32_t>(tree_.texts.size() - 1));
    }
    return std::nullopt;
}

bool Lexer::foreign_letter() const {
    return cursor_ < limit_ && (static_cast<unsigned char>(*cursor_) & 0x80) &&
           !foreign_sign(rest());
}

/// Reads and reports a name with letters that names cannot have.
Token Lexer::read_foreign_word(const char* first) {
    while (cursor_ < limit_ && (in_name(*cursor_) || foreign_letter())) ++cursor_;
    report(error(Fault::unknown_character, span(first, cursor_),
                 "a name consists of the letters A to Z and a to z, digits and `_`"));
    const std::string_view spelling(first, static_cast<std::size_t>(cursor_ - first));
    return token(TokenKind::name, first, static_cast<std::uint32_t>(names_.intern(spelling)));
}

}  // namespace candelabra
