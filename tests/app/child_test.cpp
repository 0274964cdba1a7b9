// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/child.h"

#include "text/shell_word.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("programs are found where the shell finds them", "[app]") {
    CHECK_FALSE(find_program("sh").empty());
    CHECK(find_program("no-such-program-here").empty());
}

TEST_CASE("a program's exit status is told from its not running at all", "[app]") {
    const std::string shell = find_program("sh");
    CHECK(run_program({shell, "-c", "exit 3"}) == 3);
    CHECK(run_program({shell, "-c", "kill -9 $$"}) == -1);
    CHECK(run_program({"/no/such/program"}) == -1);
}

TEST_CASE("any text is one word of the shell", "[app]") {
    const std::string odd = "it's \"a\" `b` \\";
    CHECK(run_program({find_program("sh"), "-c", "[ " + shell_quoted(odd) + " = \"$0\" ]", odd}) ==
          0);
}

}  // namespace candelabra
