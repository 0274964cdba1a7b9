// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/token_stream.h"

#include <algorithm>

namespace {

/// Copies double with each condition of this kind behind another; what needs more is not copied.
constexpr std::size_t most_ahead = 100'000;

/// How many braces are open, where each directive that is closed counts as its first part does.
class Balance {
public:
    int braces = 0;

    std::size_t directives() const { return open_.size(); }

    void add(TokenKind kind) {
        if (kind == TokenKind::open_brace) ++braces;
        if (kind == TokenKind::close_brace) --braces;
        if (opens_directive(kind)) open_.push_back({braces, std::nullopt});
        if (divides_directive(kind) && !open_.empty()) end_part();
        if (kind == TokenKind::hash_end && !open_.empty()) {
            end_part();
            braces = *open_.back().behind;
            open_.pop_back();
        }
    }

private:
    struct Directive {
        int before;
        std::optional<int> behind;  ///< the first part
    };

    void end_part() {
        Directive& directive = open_.back();
        if (!directive.behind) directive.behind = braces;
        braces = directive.before;
    }

    std::vector<Directive> open_;
};

}  // namespace

Token TokenStream::next() {
    if (ahead_.empty()) return lexer_.next();
    const Token token = ahead_.front();
    ahead_.pop_front();
    return token;
}

Token TokenStream::take(Tokens& taken) {
    taken.push_back(next());
    return taken.back();
}

bool TokenStream::take_branches(std::vector<Tokens>& branches, Tokens& taken, int braces) {
    branches.emplace_back();
    Balance balance;
    for (;;) {
        const Token token = take(taken);
        const bool ends = balance.directives() == 0 &&
                          (divides_directive(token.kind) || token.kind == TokenKind::hash_end);
        if (token.kind == TokenKind::end_of_file || taken.size() > most_ahead ||
            (ends && balance.braces != braces))
            return false;
        if (!ends) {
            balance.add(token.kind);
        } else if (token.kind == TokenKind::hash_end) {
            return true;
        } else {
            balance = {};
            branches.emplace_back();
        }
        branches.back().push_back(token);
    }
}

std::optional<std::vector<Token>> TokenStream::take_rest(Tokens& taken, int braces) {
    Tokens rest;
    Balance balance;
    while (balance.braces > -braces || balance.directives() > 0) {
        const Token token = take(taken);
        const bool outside = balance.directives() == 0 &&
                             (divides_directive(token.kind) || token.kind == TokenKind::hash_end);
        if (token.kind == TokenKind::end_of_file || outside || taken.size() > most_ahead)
            return std::nullopt;
        balance.add(token.kind);
        rest.push_back(token);
    }
    return rest;
}

bool TokenStream::copy_rest_into_branches(const Token& divider, int braces) {
    Tokens taken, result;
    std::vector<Tokens> branches;
    const bool one = divider.kind == TokenKind::hash_else;
    const bool found =
        take_branches(branches, taken, braces) &&
        (one ? branches.size() == 1
             : branches.size() > 1 && branches.back().front().kind == TokenKind::hash_else);
    const Token end = found ? taken.back() : Token{};
    const std::optional<Tokens> rest = found ? take_rest(taken, braces) : std::nullopt;
    if (!rest) {
        ahead_.insert(ahead_.begin(), taken.begin(), taken.end());
        return false;
    }
    result = *rest;
    result.push_back(divider);
    for (const Tokens& branch : branches) {
        result.insert(result.end(), branch.begin(), branch.end());
        result.insert(result.end(), rest->begin(), rest->end());
    }
    result.push_back(end);
    ahead_.insert(ahead_.begin(), result.begin(), result.end());
    return true;
}
