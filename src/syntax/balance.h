// SPDX-License-Identifier: GPL-3.0-or-later
// The number of braces that a run of tokens leaves open.
#pragma once

#include "syntax/token_classes.h"

#include <optional>
#include <vector>

namespace candelabra {

/// Counts open braces. A directive that has ended counts as its first part does.
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
        std::optional<int> behind;  ///< braces after its first part, once that has ended
    };

    void end_part() {
        Directive& directive = open_.back();
        if (!directive.behind) directive.behind = braces;
        braces = directive.before;
    }

    std::vector<Directive> open_;
};

}  // namespace candelabra
