// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/shutter.h"

#include "support/scripts.h"
#include "text/message.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Scene lamp_at(double clock) {
    return scene_of(message("#version 3.7; camera { shutter 1, 3 } sphere { ", clock,
                            ", 1 pigment { rgb 1 } finish { emission 1 } }"));
}

}  // namespace

TEST_CASE("a world has a world for each shutter sample after the first", "[world]") {
    const SourceStore sources;
    Diagnostics diagnostics;
    std::vector<double> asked;
    const ShutterScenes scenes{sources, [&](double ahead) {
                                   asked.push_back(ahead);
                                   return std::optional(lamp_at(ahead));
                               }};
    const SharedWorld world = compile(lamp_at(0), {}, diagnostics, &scenes);
    CHECK(asked == std::vector<double>{1.0 / 3, 2.0 / 3});
    REQUIRE(world->shutter.size() == 2);
    CHECK(world->shutter[1].geometry.spheres[0].centre == Vec3(2.0 / 3));
    CHECK(compile(lamp_at(0), {}, diagnostics)->shutter.empty());
}

TEST_CASE("a shutter sample that cannot be made is the last that is asked for", "[world]") {
    const SourceStore sources;
    Diagnostics diagnostics;
    int asked = 0;
    const ShutterScenes scenes{sources, [&](double) {
                                   ++asked;
                                   return std::optional<Scene>();
                               }};
    CHECK(compile(lamp_at(0), {}, diagnostics, &scenes)->shutter.empty());
    CHECK(asked == 1);
}

TEST_CASE("lights of all shutter samples are counted by the statements that make them", "[world]") {
    SourceStore sources;
    const SourceId scene = sources.add("a.pov", "lamp lamp lamp"),
                   again = sources.add("a.pov", "lamp lamp lamp");
    const auto span = [](SourceId source, std::uint32_t first) {
        return Span{source, first, first + 4};
    };
    World world, second;
    world.provenance.add_light_statement(span(scene, 0));
    world.provenance.add_light_statement(span(scene, 10));
    world.provenance.statement_of_luminaire = {1, 0, 1};
    second.provenance.add_light_statement(span(again, 5));
    second.provenance.add_light_statement(span(again, 10));
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

TEST_CASE("light with a name is that light wherever it is made in shutter samples", "[world]") {
    const SourceStore sources;
    World world, second;
    world.provenance.add_light_statement({}, "A");
    world.provenance.add_light_statement({}, "B");
    second.provenance.add_light_statement({}, "B");
    second.provenance.statement_of_luminaire = {0};
    world.shutter.push_back(std::move(second));
    share_light_statements(world, sources);
    CHECK(world.provenance.light_names == std::vector<std::string>{"A", "B"});
    CHECK(world.shutter[0].provenance.statement_of_luminaire == std::vector<std::uint32_t>{1});
}

}  // namespace candelabra
