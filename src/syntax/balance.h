// SPDX-License-Identifier: GPL-3.0-or-later
// How many braces a run of tokens opens or closes.
#pragma once

#include "syntax/token_classes.h"

#include <optional>
#include <vector>

namespace candelabra {

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

}  // namespace candelabra
