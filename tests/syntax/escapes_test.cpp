// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/escapes.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("escapes of strings", "[lexer]") {
    struct Case {
        const char* raw;
        const char* meant;
        std::size_t errors;
    };
    const auto [raw, meant, errors] = GENERATE(values<Case>({
        {"plain", "plain", 0},
        {R"(a\tb\\c\"d\'e)", "a\tb\\c\"d'e", 0},
        {R"(\u0041\u00e9\u20ac)", "A\u00E9\u20AC", 0},
        {"a\r\nb\rc\n", "a\nb\nc\n", 0},
        {R"(C:\data)", "C:\\data", 1},
        {R"(\u12)", "\\u12", 1},
        {"end\\", "end\\", 0},
    }));
    Diagnostics diagnostics;
    CHECK(unescaped(raw, 0, 10, diagnostics) == meant);
    CHECK(diagnostics.error_count() == errors);
}

TEST_CASE("an unknown escape is pointed at", "[lexer]") {
    Diagnostics diagnostics;
    unescaped("ab\\qd", 0, 10, diagnostics);
    REQUIRE(diagnostics.all().size() == 1);
    CHECK(diagnostics.all()[0].span == Span{0, 12, 14});
}

}  // namespace candelabra
