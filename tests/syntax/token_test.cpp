// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/token.h"

#include <catch2/catch.hpp>

#include <set>

namespace candelabra {

TEST_CASE("each kind of token has a name of its own", "[syntax]") {
    std::set<std::string_view> names;
    const auto count = static_cast<std::size_t>(TokenKind::semicolon) + 1;
    for (std::size_t i = 0; i < count; ++i) names.insert(name(TokenKind(i)));
    CHECK(names.size() == count);
    CHECK(names.count("") == 0);
    CHECK(name(TokenKind::semicolon) == ";");
}

}  // namespace candelabra
