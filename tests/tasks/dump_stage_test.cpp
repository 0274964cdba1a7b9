// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/dump_stage.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a dump of the scene is a scene with the same dump") {
    Shell shell;
    CHECK(shell.render({"--dump", "scene"}) == 0);
    const std::string dump = shell.out;
    shell.write("dump.pov", dump);
    CHECK(shell({shell.path("dump.pov"), "--dump", "scene"}) == 0);
    CHECK(shell.out == dump);
}

TEST_CASE("every stage can be dumped") {
    Shell shell;
    for (const char* stage : {"tokens", "tree", "scene", "world"}) {
        CAPTURE(stage);
        CHECK(shell.render({"--dump", stage}) == 0);
        CHECK(shell.out.size() > 100);
        CHECK(shell.err.empty());
    }
}

}  // namespace candelabra
