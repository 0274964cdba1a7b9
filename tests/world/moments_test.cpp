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
    world.provenance.light_statements = {span(scene, 0), span(scene, 10)};
    world.provenance.statement_of_luminaire = {1, 0, 1};
    second.provenance.light_statements = {span(again, 5), span(again, 10)};
    second.provenance.statement_of_luminaire = {0, 1};
    second.provenance.statement_of_light = {1};
    world.shutter.push_back(std::move(second));
    share_light_statements(world, sources);
    const std::vector<Span> all = {span(scene, 0), span(scene, 10), span(again, 5)};
    CHECK(world.provenance.light_statements == all);
    CHECK(world.provenance.statement_of_luminaire == std::vector<std::uint32_t>{1, 0, 1});
    CHECK(world.shutter[0].provenance.light_statements == all);
    CHECK(world.shutter[0].provenance.statement_of_luminaire == std::vector<std::uint32_t>{2, 1});
    CHECK(world.shutter[0].provenance.statement_of_light == std::vector<std::uint32_t>{1});
}
