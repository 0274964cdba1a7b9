// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/span.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a default span is nowhere, and any other is somewhere") {
    CHECK_FALSE(Span{}.known());
    CHECK(Span{0, 0, 0}.known());
}

TEST_CASE("join covers both spans of one source and keeps the first of two sources") {
    struct Case {
        Span a, b, joined;
    };
    const Case cases[] = {
        {{0, 2, 5}, {0, 7, 9}, {0, 2, 9}}, {{0, 7, 9}, {0, 2, 5}, {0, 2, 9}},
        {{0, 2, 9}, {0, 3, 4}, {0, 2, 9}}, {{0, 4, 4}, {0, 4, 6}, {0, 4, 6}},
        {{0, 2, 5}, {1, 0, 9}, {0, 2, 5}}, {{1, 0, 9}, {0, 2, 5}, {1, 0, 9}},
        {Span{}, {1, 2, 5}, {1, 2, 5}},    {{1, 2, 5}, Span{}, {1, 2, 5}},
        {Span{}, Span{}, Span{}},
    };
    for (const Case& each : cases) CHECK(join(each.a, each.b) == each.joined);
}

}  // namespace candelabra
