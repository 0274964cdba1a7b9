// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/animation_run.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace fs = std::filesystem;

TEST_CASE("shards of an animation have every so many frames") {
    Shell shell;
    const std::string file = "+O" + shell.path("f.png");
    REQUIRE(shell.render({"-V", file, "+KFF5", "--shard", "2/3"}) == 0);
    for (const int frame : {1, 2, 3, 4, 5})
        CHECK(fs::exists(shell.path("f" + std::to_string(frame) + ".png")) ==
              (frame == 2 || frame == 5));
    CHECK(shell.render({"-V", file, "+KFF5", "--shard", "4/3"}) == 2);
}

TEST_CASE("+C goes on with an animation at the frame that was begun") {
    Shell shell;
    const std::string file = "+O" + shell.path("f.png");
    int calls = 0;
    shell.interrupts.take = [&] { return ++calls == 500 ? Interrupt::stop : Interrupt::none; };
    CHECK(shell.render({"-V", file, "+KFF3", "+WT1", "+C"}) == exit_status::stopped);
    CHECK(fs::exists(shell.path("f1.png")));
    CHECK(fs::exists(shell.path("f2.png.state.exr")));
    shell.write("f1.png", "kept");
    CHECK(shell.render({"-V", file, "+KFF3", "+C"}) == 0);
    CHECK(shell.content("f1.png") == "kept");
    CHECK(fs::exists(shell.path("f2.png")));
    CHECK(fs::exists(shell.path("f3.png")));
    CHECK_FALSE(fs::exists(shell.path("f2.png.state.exr")));
}
