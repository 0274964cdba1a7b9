// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/moments.h"

#include <catch2/catch.hpp>

TEST_CASE("lights of all moments are counted by the statements that make them", "[world]") {
    SourceStore sources;
    const SourceId scene = sources.add("a.pov", "lamp lamp lamp"),
                   again = sources.add("a.pov", "lamp lamp lamp");
    const auto span = [](SourceId source, std::uint32_t first) {
        return Span{source, first, first + 4};
    };
    World world, second;
    world.light_statements = {span(scene, 0), span(scene, 10)};
    world.statement_of_luminaire = {1, 0, 1};
    second.light_statements = {span(again, 5), span(again, 10)};
    second.statement_of_luminaire = {0, 1};
    second.statement_of_light = {1};
    world.other_moments.push_back(std::move(second));
    share_light_statements(world, sources);
    const std::vector<Span> all = {span(scene, 0), span(scene, 10), span(again, 5)};
    CHECK(world.light_statements == all);
    CHECK(world.statement_of_luminaire == std::vector<std::uint32_t>{1, 0, 1});
    CHECK(world.other_moments[0].light_statements == all);
    CHECK(world.other_moments[0].statement_of_luminaire == std::vector<std::uint32_t>{2, 1});
    CHECK(world.other_moments[0].statement_of_light == std::vector<std::uint32_t>{1});
}
