// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_run.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("each task over a scene has its row, and needs the scene's text") {
    Shell shell;
    shell.write("lit.pov", std::string(lit_scene) + "meter { points { 1, <0, 0, 0> } }\n");
    const std::vector<std::vector<std::string>> tasks = {{"-F"},
                                                         {"--check"},
                                                         {"--check=syntax"},
                                                         {"--dump=tokens"},
                                                         {"--dump=tree"},
                                                         {"--dump=scene"},
                                                         {"--dump=world"},
                                                         {"--dump=index"},
                                                         {"--export-mesh", shell.path("a.ply")},
                                                         {"--measure", shell.path("a.csv")},
                                                         {"--light-balance", shell.path("b.csv")}};
    for (std::vector<std::string> task : tasks) {
        CAPTURE(task);
        CHECK(shell.render(task) == exit_status::done);
        task.insert(task.begin(), shell.path("none.pov"));
        CHECK(shell(task) == exit_status::file);
        CHECK(has(shell.err, "none.pov"));
    }
}

}  // namespace candelabra
