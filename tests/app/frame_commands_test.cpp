// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame_commands.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("commands are told the picture's facts") {
    Diagnostics diagnostics;
    const Options options = read_options(
        std::vector<std::string_view>{"a/b.pov", "+W32", "+H24", "+Ox.png", "+K0.5"}, diagnostics);
    const CommandFacts facts = command_facts(options);
    CHECK(facts.output == "x.png");
    CHECK(facts.scene == "a/b");
    CHECK(facts.width == 32);
    CHECK(facts.height == 24);
    CHECK(facts.clock == 0.5);
}

TEST_CASE("without commands the work's status is the picture's") {
    Options options;
    options.scene = "a.pov";
    CHECK(with_frame_commands(options, [] { return 0; }).status == 0);
    const Outcome failed = with_frame_commands(options, [] { return 3; });
    CHECK(failed.status == 3);
    CHECK(failed.ends);
}

}  // namespace candelabra
