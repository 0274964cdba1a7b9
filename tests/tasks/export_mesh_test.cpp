// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/export_mesh.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a mesh needs no light, and a faulty scene leaves none") {
    Shell shell;
    shell.write("a.pov", "#version 3.7; box { 0, 1 }");
    const auto run = [&] {
        return shell({shell.path("a.pov"), "--export-mesh", shell.path("a.ply"), "-V"});
    };
    REQUIRE(run() == exit_status::done);
    CHECK(shell.err.empty());  // a picture of it would be black, which a rendering warns of
    std::filesystem::remove(shell.path("a.ply"));
    shell.write("a.pov", "#version 3.7; box { 0, 1 } bxo { 0, 1 }");
    CHECK(run() == exit_status::scene);
    CHECK(has(shell.err, "did you mean `box`?"));
    CHECK_FALSE(std::filesystem::exists(shell.path("a.ply")));
}

}  // namespace candelabra
