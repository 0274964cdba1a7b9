// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/check_scene.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("a check says that there are no errors, and writes no picture") {
    Shell shell;
    for (const char* check : {"--check", "--check=syntax"}) {
        CHECK(shell.render({check, "+O" + shell.path("x.png")}) == 0);
        CHECK(has(shell.err, "lit.pov: no errors\n"));
        CHECK(shell.out.empty());
        CHECK_FALSE(fs::exists(shell.path("x.png")));
    }
    // The syntax check ignores errors that only evaluation can find.
    shell.write("unknown.pov", "sphere { Nowhere, 1 }\n");
    CHECK(shell({shell.path("unknown.pov"), "--check=syntax"}) == 0);
    CHECK(shell({shell.path("unknown.pov"), "--check"}) == 1);
}

}  // namespace candelabra
