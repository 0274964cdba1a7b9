// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/shell_word.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("any text is one word of the shell") {
    CHECK(shell_quoted("") == "''");
    CHECK(shell_quoted("a b$c") == "'a b$c'");
    CHECK(shell_word("a+b=c.d") == "a+b=c.d");
    CHECK(shell_word("").size() == 2);
    CHECK(shell_word("a'b") == "'a'\\''b'");
}

}  // namespace candelabra
