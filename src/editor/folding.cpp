// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/folding.h"

#include "editor/protocol.h"
#include "syntax/token_classes.h"

#include <algorithm>
#include <map>

namespace candelabra {

namespace {

class Folds {
public:
    explicit Folds(const EditedFile& file) : file_(file), lines_(file.text) {}

    std::vector<Fold> operator()() {
        for (const Token& token : file_.tokens) follow(token);
        add_comments();
        add_includes();
        std::vector<Fold> all;
        for (const auto& [line, fold] : found_) all.push_back(fold);
        return all;
    }

private:
    static constexpr std::size_t max_unclosed = 100;

    struct Opening {
        TokenKind kind;
        std::size_t line;
    };

    std::size_t line_of(std::uint32_t offset) const { return lines_.line_of(offset); }

    /// Of the folds that begin in a line, keeps the longest.
    void add(std::size_t first, std::size_t last, Fold::Kind kind) {
        if (last <= first) return;
        Fold& there = found_.try_emplace(first, Fold{first, last, kind}).first->second;
        if (there.last_line < last) there = {first, last, kind};
    }

    void add_code(std::size_t first, std::size_t closing) {
        if (closing > 0) add(first, closing - 1, Fold::code);
    }

    void follow(const Token& token) {
        if (opens(token.kind)) {
            open_.push_back({token.kind, line_of(token.first)});
        } else if (divides_directive(token.kind)) {
            while (!open_.empty() && !opens_directive(open_.back().kind)) open_.pop_back();
            if (open_.empty()) return;
            add_code(open_.back().line, line_of(token.first));
            open_.back().line = line_of(token.first);
        } else if (closes(token.kind)) {
            close(token);
        }
    }

    /// Closes the innermost matching bracket without leaving a directive, unless very many brackets
    /// inside it are still open.
    void close(const Token& token) {
        const std::size_t end = open_.size() - std::min(open_.size(), max_unclosed);
        for (std::size_t i = open_.size(); i-- > end;) {
            const TokenKind closer = closer_of(open_[i].kind);
            if (closer == token.kind) {
                add_code(open_[i].line, line_of(token.first));
                open_.resize(i);
                return;
            }
            if (closer == TokenKind::hash_end) return;
        }
    }

    /// Adds comments of several lines, and runs of one-line comments on consecutive lines.
    void add_comments() {
        for (std::size_t i = 0; i < file_.comments.size();) {
            const std::size_t first = line_of(file_.comments[i].first);
            std::size_t last = line_of(file_.comments[i].last);
            const bool alone = stands_alone(file_.comments[i]);
            for (++i; alone && i < file_.comments.size(); ++i) {
                if (line_of(file_.comments[i].first) != last + 1) break;
                if (!stands_alone(file_.comments[i])) break;
                last = line_of(file_.comments[i].last);
            }
            add(first, last, Fold::comment);
        }
    }

    /// Whether the comment is the first text in its line.
    bool stands_alone(Part comment) const {
        const std::string_view before = std::string_view(file_.text).substr(0, comment.first);
        const std::size_t last = before.find_last_not_of(" \t");
        return last == before.npos || before[last] == '\n' || before[last] == '\r';
    }

    void add_includes() {
        std::size_t first = 0, last = 0;
        bool any = false;
        for (const Token& token : file_.tokens) {
            const bool include = token.kind == TokenKind::hash_include;
            if (!include && token.kind != TokenKind::text) {
                any = false;
                continue;
            }
            last = line_of(token.first);
            if (include && !any) first = last;
            any |= include;
            if (any && include) add(first, last, Fold::imports);
        }
    }

    const EditedFile& file_;
    LineTable lines_;
    std::vector<Opening> open_;
    std::map<std::size_t, Fold> found_;  ///< by first line
};

}  // namespace

std::vector<Fold> folds(const EditedFile& file) { return Folds(file)(); }

}  // namespace candelabra
