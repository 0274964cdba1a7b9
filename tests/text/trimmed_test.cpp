// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/trimmed.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("blanks around a text are left out, and those within it are kept", "[text]") {
    CHECK(trimmed("", " ").empty());
    CHECK(trimmed("  ", " ").empty());
    CHECK(trimmed(" a b ", " ") == "a b");
    CHECK(trimmed("\ta\t", " ") == "\ta\t");
    CHECK(trimmed(" \ta b\r\n", " \t\r\n") == "a b");
    CHECK(trimmed("a", " ") == "a");
    CHECK(trimmed("a", "") == "a");
}

}  // namespace candelabra
