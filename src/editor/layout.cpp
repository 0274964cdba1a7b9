// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/layout.h"

#include "editor/edited_file.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace candelabra {

namespace {

constexpr int step = 4;
/// Deeper levels are indented as this one: else a text of n levels would get n*n blanks.
constexpr int deepest_column = 64 * step;
constexpr std::string_view blanks = " \t\f\v";

/// An open bracket or directive, and the columns (from 0) of the lines that follow.
struct Opening {
    TokenKind kind;
    int outside;          ///< of the line that closes it
    int dividers;         ///< of its dividers: #else, #case
    int inside;           ///< of all other lines
    bool closed = false;  ///< but brackets or directives in it are open

    bool is_directive() const { return opens_directive(kind); }
    bool is_block() const { return is_directive() || kind == TokenKind::open_brace; }
};

bool opens_bracket(TokenKind kind) {
    return kind == TokenKind::open_brace || kind == TokenKind::open_parenthesis ||
           kind == TokenKind::open_bracket;
}

bool closes_bracket(TokenKind kind) {
    return kind == TokenKind::close_brace || kind == TokenKind::close_parenthesis ||
           kind == TokenKind::close_bracket;
}

/// Whether a value may end with this token, so that a following `<` is a comparison.
bool ends_value(TokenKind kind) {
    using enum TokenKind;
    return kind == name || kind == number || kind == literal || kind == text || kind == constant ||
           kind == channel || kind == close_parenthesis || kind == close_bracket;
}

/// Whether an expression must continue after this token.
bool asks_for_more(TokenKind kind) {
    using enum TokenKind;
    return kind == equal || kind == plus || kind == minus || kind == times || kind == divide ||
           kind == both || kind == either || kind == question || kind == colon;
}

/// Returns the #ifndef around a whole file, its include guard; null if there is none.
const Token* guard(const std::vector<Token>& tokens) {
    if (tokens.empty() || tokens.back().kind != TokenKind::hash_end) return nullptr;
    int ends = 0;
    for (std::size_t i = tokens.size(); i-- > 0;) {
        if (tokens[i].kind == TokenKind::hash_end) ++ends;
        if (opens_directive(tokens[i].kind) && --ends == 0)
            return tokens[i].kind == TokenKind::hash_ifdef ? &tokens[i] : nullptr;
    }
    return nullptr;
}

class Layout {
public:
    explicit Layout(std::string_view text) : text_(text) {
        for (std::size_t at = 0; at <= text.size(); ++at)
            if (at == 0 || text[at - 1] == '\n') starts_.push_back(at);
        if (text.empty() || text.back() == '\n') starts_.pop_back();
        columns_.resize(starts_.size());
        kept_.resize(starts_.size());
        kept_ends_.resize(starts_.size());
        last_line_ = starts_.size();
    }

    /// Lays out all lines, or those that were chosen.
    std::string operator()() {
        Names names;
        const EditedFile file = read_tokens(std::string(text_), names);
        keep_inside(file.comments);
        for (const Token& token : file.tokens)
            if (token.kind == TokenKind::text) keep_inside(token.first, token.last);
        guard_ = guard(file.tokens);
        std::size_t line = 0;
        for (std::size_t i = 0; i < file.tokens.size(); ++i) {
            const Token& token = file.tokens[i];
            const std::size_t own = line_of(token.first);
            for (; line <= own && line < starts_.size(); ++line)
                set_column(line, line == own ? column_before(token) : column_within());
            const bool last = i + 1 == file.tokens.size() ||
                              line_of(file.tokens[i + 1].first) != line_of(token.last);
            follow(token, last ? nullptr : &file.tokens[i + 1]);
            const std::size_t end = line_of(token.last);  // of a long vector
            for (; line <= end && line < starts_.size(); ++line)
                set_column(line, column_of(token) + 1);
        }
        for (; line < starts_.size(); ++line) set_column(line, column_within());
        return written();
    }

    /// Restricts the layout to the lines that overlap the part. Returns the extent of these lines.
    Part choose(Part part) {
        if (starts_.empty()) return {};
        first_line_ = line_of(part.first);
        // A part that ends at the beginning of a line does not include that line.
        last_line_ = line_of(part.last > part.first ? part.last - 1 : part.last) + 1;
        const std::size_t end = last_line_ < starts_.size() ? starts_[last_line_] : text_.size();
        return {static_cast<std::uint32_t>(starts_[first_line_]), static_cast<std::uint32_t>(end)};
    }

private:
    void set_column(std::size_t line, int column) {
        const bool chosen = first_line_ <= line && line < last_line_;
        columns_[line] = chosen ? std::min(column, deepest_column) : present_column(line);
    }

    /// Column of the first character in the original line.
    int present_column(std::size_t line) const {
        int column = 0;
        for (const char blank : line_text(line).substr(0, indentation(line)))
            column = blank == '\t' ? (column / step + 1) * step : column + 1;
        return column;
    }

    std::size_t line_of(std::size_t offset) const {
        const auto next = std::ranges::upper_bound(starts_, offset);
        return static_cast<std::size_t>(next - starts_.begin()) - 1;
    }

    void keep_inside(const std::vector<Part>& parts) {
        for (const Part& part : parts) keep_inside(part.first, part.last);
    }

    /// Lines that begin or end within the part keep their blanks at that end.
    void keep_inside(std::size_t first, std::size_t last) {
        for (std::size_t line = line_of(first); line < line_of(last); ++line) {
            kept_ends_[line] = true;
            kept_[line + 1] = true;
        }
    }

    std::size_t indentation(std::size_t line) const {
        const std::string_view content = line_text(line);
        return std::min(content.find_first_not_of(blanks), content.size());
    }

    /// Column in the new layout.
    int column_of(const Token& token) const {
        const std::size_t line = line_of(token.first);
        return columns_[line] + static_cast<int>(token.first - starts_[line] - indentation(line));
    }

    int column_within() const { return open_.empty() ? 0 : open_.back().inside; }

    /// Column of a line that begins with the token; a closing bracket aligns with its opening line.
    int column_before(const Token& token) {
        const bool divides = divides_directive(token.kind);
        const bool of_directive =
            divides || token.kind == TokenKind::hash_end || token.kind == TokenKind::hash_break;
        if (!of_directive && !closes(token)) {
            const bool list = !open_.empty() && !open_.back().is_block();
            return column_within() + (asks_for_more(previous_) && !list ? step : 0);
        }
        if (token.kind == TokenKind::hash_break) {
            const bool in_switch = !open_.empty() && open_.back().kind == TokenKind::hash_switch;
            return in_switch ? open_.back().dividers : column_within();
        }
        const Opening* const around = innermost(of_directive);
        return !around ? column_within() : divides ? around->dividers : around->outside;
    }

    bool closes(const Token& token) const {
        if (token.kind != TokenKind::greater) return closes_bracket(token.kind);
        const Opening* const last = innermost(false);
        return last && last->kind == TokenKind::less;
    }

    /// The innermost open directive or bracket; null if there is none.
    const Opening* innermost(bool directive) const {
        const std::vector<std::size_t>& all = directive ? directives_ : brackets_;
        return all.empty() ? nullptr : &open_[all.back()];
    }

    /// `behind`: the next token in the same line, or null.
    void follow(const Token& token, const Token* behind) {
        const bool vector = token.kind == TokenKind::less && !ends_value(previous_);
        previous_ = token.kind;
        if (divides_directive(token.kind)) end_branch();
        if (vector || opens_bracket(token.kind) || opens_directive(token.kind)) open(token, behind);
        // If a branch closes a brace that was opened before its directive, remove that one.
        if (closes(token)) close(false);
        // Braces that the last branch leaves open stay open after the directive.
        if (token.kind == TokenKind::hash_end) close(true);
    }

    void open(const Token& token, const Token* behind) {
        const int outside = columns_[line_of(token.first)];
        Opening opening{token.kind, outside, outside, outside + step};
        if (&token == guard_) opening.inside = outside;
        if (token.kind == TokenKind::hash_switch) {
            opening.dividers += step;
            opening.inside += step;
        }
        if (!opening.is_block() && behind) opening.inside = column_of(*behind);
        (opening.is_directive() ? directives_ : brackets_).push_back(open_.size());
        open_.push_back(opening);
    }

    void close(bool directive) {
        std::vector<std::size_t>& all = directive ? directives_ : brackets_;
        if (all.empty()) return;
        open_[all.back()].closed = true;
        all.pop_back();
        while (!open_.empty() && open_.back().closed) open_.pop_back();
    }

    /// Each branch leaves the same brackets open, so they are counted once.
    void end_branch() {
        while (!open_.empty() && !open_.back().is_directive()) close(false);
    }

    std::string_view line_text(std::size_t line) const {
        const std::size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
        return text_.substr(starts_[line], end - starts_[line]);
    }

    static std::string_view without_line_end(std::string_view line) {
        while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
        return line;
    }

    bool is_empty(std::size_t line) const {
        return !kept_[line] && !kept_ends_[line] &&
               without_line_end(line_text(line)).find_first_not_of(blanks) ==
                   std::string_view::npos;
    }

    /// Number of empty lines before the first line; two are allowed at most.
    int empty_lines_before() const {
        int count = 0;
        for (std::size_t line = first_line_; line-- > 0 && is_empty(line) && count < 2;) ++count;
        return first_line_ == 0 ? 2 : count;  // allow none at the beginning
    }

    std::string written() const {
        const std::string_view line_end = text_.find("\r\n") < text_.find('\n') ? "\r\n" : "\n";
        std::string result;
        int empty = empty_lines_before();
        for (std::size_t line = first_line_; line < last_line_; ++line) {
            std::string_view content = without_line_end(line_text(line));
            if (!kept_ends_[line])
                content = content.substr(0, content.find_last_not_of(blanks) + 1);
            if (!kept_[line])
                content.remove_prefix(std::min(content.find_first_not_of(blanks), content.size()));
            empty = is_empty(line) ? empty + 1 : 0;
            if (is_empty(line) && empty > 2) continue;
            if (!is_empty(line) && !kept_[line])
                result.append(static_cast<std::size_t>(columns_[line]), ' ');
            result.append(content).append(line_end);
        }
        return last_line_ < starts_.size() ? result
                                           : without_empty_end(std::move(result), line_end);
    }

    std::string without_empty_end(std::string result, std::string_view line_end) const {
        while (result.ends_with(std::string(line_end) + std::string(line_end)))
            result.resize(result.size() - line_end.size());
        const bool nothing = result == line_end && (first_line_ == 0 || !kept_[last_line_ - 1]);
        return nothing ? "" : result;
    }

    std::string_view text_;
    std::vector<std::size_t> starts_;     ///< of the lines
    std::vector<int> columns_;            ///< of each line's first character in the new layout
    std::vector<bool> kept_, kept_ends_;  ///< lines whose first or last blanks belong to a comment
                                          ///< or string
    std::size_t first_line_ = 0;          ///< of those to lay out
    std::size_t last_line_ = 0;           ///< the line after the last of them
    std::vector<Opening> open_;           ///< the last of them is not closed
    std::vector<std::size_t> directives_, brackets_;  ///< those in open_ that are not closed
    const Token* guard_ = nullptr;
    TokenKind previous_ = TokenKind::end_of_file;
};

}  // namespace

std::string laid_out(std::string_view text) { return Layout(text)(); }

LaidOutPart laid_out_lines(std::string_view text, Part part) {
    Layout layout(text);
    const Part place = layout.choose(part);
    return {place, layout()};
}

}  // namespace candelabra
