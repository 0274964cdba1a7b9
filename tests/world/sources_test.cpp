// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/sources.h"

#include "support/scripts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

std::vector<PointLight> lights(std::size_t count, const PointLight& like = {}) {
    std::vector<PointLight> result;
    for (std::size_t i = 0; i < count; ++i) {
        PointLight light = like;
        light.location = Vec3(static_cast<double>(i), 1, 0);
        light.colour = Rgb(1);
        result.emplace_back(light);
    }
    return result;
}

std::vector<SourceSet> sets(const std::vector<PointLight>& lights,
                            const LightSampler& sampler = LightOctree{}) {
    const std::vector<std::uint32_t> groups(lights.size(), 0);
    return source_sets(lights, groups, sampler);
}

}  // namespace

TEST_CASE("few light sources are all asked, some of many", "[world]") {
    CHECK(sets({}).empty());
    const auto few = sets(lights(max_asked_sources));
    REQUIRE(few.size() == 1);
    CHECK_FALSE(few[0].drawn());
    CHECK(few[0].lights.size() == max_asked_sources);
    const auto many = sets(lights(max_asked_sources + 1));
    REQUIRE(many.size() == 1);
    CHECK(many[0].drawn());
    CHECK(many[0].choices->size() == max_asked_sources + 1);
    CHECK_FALSE(sets(lights(max_asked_sources + 1), EveryLight{})[0].drawn());
}

TEST_CASE("lights that take light away are all asked, those without light never", "[world]") {
    std::vector<PointLight> all = lights(200);
    all[7].colour = Rgb(1, -0.1, 1);
    all[8].colour = Rgb(0);
    const auto found = sets(all);
    REQUIRE(found.size() == 2);
    CHECK(found[0].lights == std::vector<std::uint32_t>{7});
    CHECK(found[1].lights.size() == 198);
    CHECK(found[1].drawn());
}

TEST_CASE("light of one direction is chosen by direction", "[world]") {
    PointLight parallel;
    parallel.parallel = true;
    parallel.point_at = Vec3(3.5, 0, 0);
    const auto found = sets(lights(200, parallel));
    REQUIRE(found.size() == 1);
    CHECK(found[0].parallel);
    for (LightIndex light = 0; light < 200; ++light)
        CHECK(length(found[0].choices->bounds(light).centre) == Approx(1));
    const Receiver asked = found[0].asked({Vec3(5), Vec3(0, 1, 0)});
    CHECK(asked.position == Vec3(0));
    CHECK(asked.normal == Vec3(0, 1, 0));
}

TEST_CASE("fewer light sources are all asked where pixels have many samples anyway", "[world]") {
    const std::string some = "#for (I, 1, 50) light_source { I*x, 1 } #end plane { y, 0 } ";
    CHECK_FALSE(world_of(some)->facts.left_to_chance);
    const SharedWorld world =
        world_of(some + "sphere { y, 1 pigment { rgb 1 } finish { emission 1 } }");
    CHECK(world->lights.source_sets[0].drawn());
}

TEST_CASE("each light group has its own set", "[world]") {
    const std::string group =
        "light_group { #for (I, 1, 150) light_source { I*x, 1 } #end sphere { 0, 1 } }";
    const SharedWorld world = world_of("light_source { y, 1 } sphere { 3*x, 1 }" + group + group);
    REQUIRE(world->lights.source_sets.size() == 3);
    CHECK_FALSE(world->lights.source_sets[0].drawn());
    for (const std::size_t i : {1u, 2u}) {
        CHECK(world->lights.source_sets[i].group == i);
        CHECK(world->lights.source_sets[i].lights.size() == 150);
        CHECK(world->lights.source_sets[i].drawn());
    }
    CHECK(world->facts.light_is_drawn);
}

}  // namespace candelabra
