// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/shot.h"

#include "render/render.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <type_traits>

namespace candelabra {

namespace {

static_assert(std::is_const_v<SharedWorld::element_type>);

/// A street with lit windows, which have bent normals.
const std::string street = R"(
    #default { finish { ambient 0 diffuse 0.7 specular 0.3 } }
    plane { y, 0 pigment { rgb 0.6 } }
    #declare Lamp = texture { pigment { rgb <1, 0.8, 0.5> } finish { diffuse 0 emission 6 } }
    #for (I, 0, 11)
        box { <4*I - 24, 0, 3>, <4*I - 21, 4, 6> pigment { rgb 0.5 } }
        box { <4*I - 23, 1, 2.98>, <4*I - 22, 2, 3.02> texture { Lamp } }
        sphere { <4*I - 24, 3, -1>, 0.15 texture { Lamp } }
    #end
)";
const std::string near_eye = "camera { location <-20, 1, -3> look_at <-16, 1, 3> angle 60 } ",
                  far_eye = "camera { location <12, 6, -30> look_at <0, 1, 0> angle 40 } ",
                  in_house = "camera { location <-6.5, 3, 4> look_at <-3, 0, 5> angle 90 } ";

struct Case {
    const char* name;
    std::string more;
};

std::vector<Case> cases() {
    return {
        {"luminaires", ""},
        {"many sources", "#for (I, 0, 199) light_source { <0.3*I - 30, 5, -2>, 0.02 } #end "},
        {"media", "media { scattering { 1, rgb 0.02 } } "},
        {"media in a solid",
         "sphere { <0, 2, 0>, 2 hollow pigment { rgbt 1 } interior { media { emission 0.2 "
         "scattering { 1, rgb 0.2 } } luminaire } } "},
        {"reflected luminaires",
         "global_settings { integrator { path_traced reflected_luminaires 200 bounces 2 } } "},
        {"photons",
         "global_settings { photons { count 2000 } } sphere { <-16, 1, 0>, 1 pigment { rgbt 1 } "
         "interior { ior 1.5 } photons { target refraction on } } "},
        {"paths", "global_settings { integrator { path_traced { bounces 2 } } } "},
    };
}

SharedWorld world_seen_from(const std::string& camera, const std::string& more) {
    return world_of("#version 3.7; " + street + more + camera);
}

RenderSettings for_shots() {
    RenderSettings settings;
    settings.width = 24;
    settings.height = 18;
    settings.samples = 2;
    settings.threads = 2;
    return settings;
}

/// The cells of the light octree that chooses among the luminaires.
std::size_t cells(const Shot& shot) { return std::get<BuiltCutOctree>(shot.sampler).cells(); }

}  // namespace

TEST_CASE("shots of one world see it as worlds that are compiled for their cameras", "[world]") {
    const RenderSettings settings = for_shots();
    const ShotSettings size = ShotSettings::of(settings);
    for (const Case& each : cases()) {
        INFO(each.name);
        const SharedWorld world = world_seen_from(near_eye, each.more);
        std::vector<SharedWorld> fresh;
        std::vector<Shot> shots;
        for (const std::string& camera : {near_eye, far_eye, in_house}) {
            fresh.push_back(world_seen_from(camera, each.more));
            const Projection& wanted = fresh.back()->stated_view.camera;
            shots.emplace_back(world, size, [&](const Projection&) { return wanted; });
        }
        std::vector<Image> pictures;
        for (const bool again : {false, true})
            for (std::size_t i = 0; i < shots.size(); ++i) {
                INFO("camera " << i);
                const Image found = render(shots[i], settings).image;
                if (!again) pictures.push_back(render(Shot(fresh[i], size), settings).image);
                CHECK(found.pixels == pictures[i].pixels);
            }
        CHECK(pictures[0].pixels != pictures[1].pixels);
        CHECK(world->stated_view.camera.location == Vec3(-20, 1, -3));
    }
}

TEST_CASE("each shot has light cells of its own", "[world]") {
    const SharedWorld world = world_seen_from(near_eye, "");
    const Projection elsewhere = world_seen_from(far_eye, "")->stated_view.camera;
    const RenderSettings settings = for_shots();
    const ShotSettings size = ShotSettings::of(settings);
    const Shot one(world, size), other(world, size, [&](const Projection&) { return elsewhere; });
    CHECK(cells(one) == 0);
    render(one, settings);
    const std::size_t of_one = cells(one);
    CHECK(of_one > 0);
    CHECK(cells(other) == 0);
    render(other, settings);
    CHECK(cells(other) > 0);
    CHECK(cells(one) == of_one);
}

TEST_CASE("which windows a house hides depends on whether the eye is in it", "[world]") {
    const SharedWorld world = world_seen_from(near_eye, "");
    const Projection inside = world_seen_from(in_house, "")->stated_view.camera;
    const Shot street_shot(world), house_shot(world, {}, [&](const Projection&) { return inside; });
    REQUIRE(street_shot.bent_normals.size() == world->lights.luminaires.size());
    CHECK(street_shot.bent_normals != house_shot.bent_normals);
}

TEST_CASE("light of a closed lamp is mostly sent outwards, unless the camera is in it", "[world]") {
    const SharedWorld world = world_of(R"(#version 3.7;
        camera { location -9*z look_at 0 }
        sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
        sphere { 5*x, 1 pigment { rgbt <1, 1, 1, 0.5> } finish { emission 1 } })");
    REQUIRE(world->lights.luminaires.size() == 2);
    const Shot outside(world), inside(world, {}, [](const Projection&stated) {
        Projection camera = stated;
        camera.location = Vec3(0);
        return camera;
    });
    const Luminaire &opaque = world->lights.luminaires.own()[0],
                    &clear = world->lights.luminaires.own()[1];
    CHECK(outside.inner_rays(opaque) < 0.1);
    CHECK(outside.inner_rays(clear) == 0.5);
    CHECK(inside.inner_rays(opaque) == 0.5);
}

TEST_CASE("a quick shot chooses lights without trial, luminaires and sources", "[world]") {
    const SharedWorld world = world_of(R"(#version 3.7;
camera { location -9*z look_at 0 }
plane { y, -2 pigment { rgb 1 } }
#for (I, 1, 300)
    light_source { <I, 5, 0>, 0.01 }
#end
sphere { 0, 1 pigment { rgb 1 } finish { emission 1 } }
sphere { 3*y, 1 pigment { rgb 1 } finish { emission 1 } })");
    REQUIRE(world->lights.source_sets.size() == 1);
    REQUIRE(world->lights.source_sets[0].drawn());
    const Shot usual(world);
    CHECK(std::holds_alternative<BuiltCutOctree>(usual.sampler));
    CHECK(usual.joined == &world->lights.source_sets[0]);
    CHECK(usual.lamp(1) == Lamp::luminaire(1));
    CHECK(usual.lamp(4) == Lamp::source(world->lights.source_sets[0].lights[2]));
    REQUIRE(usual.of_sources.size() == 1);
    CHECK_FALSE(std::holds_alternative<BuiltCutOctree>(usual.of_sources[0]));
    const Shot quick(world, {.quick = true});
    CHECK_FALSE(quick.joined);
    REQUIRE(std::holds_alternative<BuiltLightBvh>(quick.sampler));
    REQUIRE(quick.of_sources.size() == 1);
    CHECK(std::holds_alternative<BuiltLightBvh>(quick.of_sources[0]));
    const Receiver point{Vec3(0, -2, 0), Vec3(0, 1, 0)};
    const BuiltLightBvh& built = std::get<BuiltLightBvh>(quick.sampler);
    CHECK(built.expected(point, {}, 0) + built.expected(point, {}, 1) == Approx(1));
}

TEST_CASE("a world without lights has none to choose", "[world]") {
    const Shot quick(world_of("#version 3.7; sphere { 0, 1 pigment { rgb 1 } }"), {.quick = true});
    CHECK_FALSE(std::holds_alternative<BuiltLightBvh>(quick.sampler));
    CHECK(quick.of_sources.empty());
}

TEST_CASE("each moment of the shutter has its own camera in a shot", "[world]") {
    const auto moved = [](int x) {
        return world_of("camera { location " + std::to_string(x) +
                        "*x look_at 9*z } sphere { 9*z, 1 }");
    };
    World moving(*moved(0));
    moving.shutter.emplace_back(*moved(1));
    moving.shutter.emplace_back(*moved(2));
    const SharedWorld world = std::make_shared<World>(std::move(moving));
    const Shot stated(world), raised(world, {}, [](const Projection&camera) {
        Projection result = camera;
        result.location.y += 5;
        return result;
    });
    REQUIRE(stated.moments() == 3);
    REQUIRE(raised.moments() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = static_cast<double>(i);
        CHECK(stated.moment(i).view.camera.location == Vec3(x, 0, 0));
        CHECK(raised.moment(i).view.camera.location == Vec3(x, 5, 0));
        CHECK(stated.moment(i).world.get() == raised.moment(i).world.get());
    }
}

TEST_CASE("glare is as wide as the camera of the shot sees it", "[world]") {
    const SharedWorld world = world_of("camera { angle 60 film { glare { } } } sphere { 9*z, 1 }");
    CHECK(world->stated_view.film.glare.field == 0);
    CHECK(Shot(world).view.film.glare.field == Approx(60));
    const Shot wide(world, {}, [](const Projection& stated) {
        Projection camera = stated;
        camera.right *= 2;
        return camera;
    });
    CHECK(wide.view.film.glare.field > 90);
}

}  // namespace candelabra
