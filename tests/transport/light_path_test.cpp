// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/light_path.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

namespace candelabra {

namespace {

std::vector<ReflectedLuminaire> sent_into(const Shot& shot, int reflections, std::uint32_t count) {
    const LightPaths paths(shot, reflections);
    std::vector<ReflectedLuminaire> found;
    for (std::uint32_t i = 0; i < count; ++i) paths.follow({7, i, 0, 0}, 1.0 / count, found);
    return found;
}

Rgb power_after(std::span<const ReflectedLuminaire> all, int reflections) {
    Rgb sum(0);
    for (const ReflectedLuminaire& each : all)
        if (each.reflections == reflections) sum += each.power;
    return sum;
}

const std::string small_lamp =
    "sphere { <1, 0.5, -1>, 0.25 pigment { rgb 1 } finish { diffuse 0 emission <8, 4, 2> } }\n";

}  // namespace

TEST_CASE("in a closed room light keeps its power times the albedo at each reflection",
          "[transport]") {
    const Shot shot = shot_of(
        "#version 3.7; #default { finish { ambient 0 } }\n" + small_lamp +
        "box { <-3, -2, -4>, <4, 3, 5> pigment { rgb <0.5, 0.8, 0.2> } finish { diffuse 1 } }");
    const auto found = sent_into(shot, 3, 40000);
    // Radiance times area of a glowing sphere, which is its power over pi.
    Rgb expected = Rgb(8, 4, 2) * (4 * std::numbers::pi * 0.25 * 0.25);
    for (int n = 1; n <= 3; ++n) {
        // A little of the light returns to the lamp, which is black.
        expected *= Rgb(0.5, 0.8, 0.2);
        const Rgb power = power_after(found, n);
        CAPTURE(n);
        for (int i = 0; i < 3; ++i) CHECK(power[i] == Approx(expected[i]).epsilon(0.03));
    }
    CHECK(power_after(found, 4) == Rgb(0));
}

TEST_CASE("reflected luminaires shine to the side from which light has come", "[transport]") {
    const Shot shot = shot_of("#version 3.7; #default { finish { ambient 0 } }\n" + small_lamp +
                              "plane { y, 0 pigment { rgb 0.7 } finish { diffuse 1 } }");
    const auto found = sent_into(shot, 8, 500);
    REQUIRE_FALSE(found.empty());
    for (const ReflectedLuminaire& each : found) {
        CHECK(each.normal == Vec3(0, 1, 0));
        CHECK(each.reflections == 1);
    }
}

TEST_CASE("light that clear surfaces let pass is as a shadow ray finds it", "[transport]") {
    const auto floor_lit = [](const std::string& pane) {
        const Shot shot =
            shot_of("#version 3.7; #default { finish { ambient 0 } }\n" + small_lamp + pane +
                    "disc { -2*y, y, 4 pigment { rgb 1 } finish { diffuse 1 } }");
        return power_after(sent_into(shot, 1, 40000), 1);
    };
    const Rgb open = floor_lit(""),
              dimmed = floor_lit(
                  "box { <-9, -1, -9>, <9, -0.9, 9> pigment { rgbt <0, 0, 0, 0.5> }"
                  " finish { diffuse 0 } }"),
              unseen = floor_lit(
                  "box { <-9, -1, -9>, <9, -0.9, 9> pigment { rgb 1 } finish { "
                  "diffuse 0 } no_shadow }"),
              shut = floor_lit("plane { y, -1 pigment { rgb 1 } finish { diffuse 0 } }");
    for (int i = 0; i < 3; ++i) {
        CHECK(dimmed[i] == Approx(0.25 * open[i]).epsilon(0.001));
        CHECK(unseen[i] == Approx(open[i]).epsilon(0.001));
    }
    CHECK(shut == Rgb(0));
}

TEST_CASE("paths of sources and of the sky have the power that these send", "[transport]") {
    const auto floor_lit = [](const std::string& light) {
        const Shot shot = shot_of(
            "#version 3.7; #default { finish { ambient 0 } } camera { location <0, 3, -4> "
            "look_at 0 } disc { 0, y, 1 pigment { rgb 1 } finish { diffuse 1 } }" +
            light);
        return power_after(sent_into(shot, 1, 600000), 1).r;
    };
    using std::numbers::pi;
    CHECK(floor_lit("light_source { 100*y, 2 parallel point_at 0 }") ==
          Approx(2 * pi).epsilon(0.03));
    CHECK(floor_lit("light_source { 1e7*y, 2 }") == Approx(2 * pi).epsilon(0.03));
    // On both sides.
    CHECK(floor_lit("sky_sphere { pigment { rgb 2 } luminaire }") == Approx(4 * pi).epsilon(0.04));
    // A light below the disc lights its other side.
    CHECK(floor_lit("light_source { -1e7*y, 2 }") == Approx(2 * pi).epsilon(0.03));
    // Half of the grid is hidden.
    const double shaded = floor_lit(
        "light_source { 5*y, 2 area_light 4*x, z, 2, 2 } box { <0.01, 2, -9>, <9, 2.1, 9> }");
    const double open = floor_lit("light_source { 5*y, 2 area_light 4*x, z, 2, 2 }");
    CHECK(shaded < 0.9 * open);
    CHECK(shaded > 0.3 * open);
}

TEST_CASE("light of the sky comes through a window by many paths, and not by a few strong ones",
          "[transport]") {
    const Shot shot = shot_of(
        "#version 3.7; #default { finish { ambient 0 diffuse 1 } } camera { location <0.6, 1.6, "
        "0.5> look_at <2.4, 1.1, 3> } difference { box { <-0.2, -0.2, -0.2>, <4.2, 3.2, 5.2> } box "
        "{ <0, 0, 0>, <4, 3, 5> } box { <3.9, 0.9, 1.5>, <4.3, 2.2, 3> } pigment { rgb 0.72 } } "
        "plane { y, -0.2 pigment { rgb 0.3 } } sky_sphere { pigment { rgb 4 } luminaire }");
    const LightPaths paths(shot, 8);
    constexpr std::uint32_t count = 40000;
    std::vector<double> in_room;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::vector<ReflectedLuminaire> found;
        paths.follow({7, i, 0, 0}, 1.0 / count, found);
        double sum = 0;
        for (const ReflectedLuminaire& each : found) {
            const Vec3& at = each.position;
            const bool inside = at.x > -0.01 && at.x < 4.01 && at.y > -0.01 && at.y < 3.01 &&
                                at.z > -0.01 && at.z < 5.01;
            if (inside) sum += each.power.g;
        }
        in_room.push_back(sum);
    }
    std::ranges::sort(in_room, std::greater());
    const auto of_first = [&](std::uint32_t paths) {
        return std::accumulate(in_room.begin(), in_room.begin() + paths, 0.0);
    };
    CAPTURE(of_first(1), of_first(count / 800), of_first(count));
    CHECK(of_first(1) < 0.05 * of_first(count));
    CHECK(of_first(count / 800) < 0.42 * of_first(count));
}

TEST_CASE("reflected luminaires stand for diffuse reflection that is the same in all directions",
          "[transport]") {
    const SharedWorld world = world_of("sphere { 0, 1 }");
    Material material = world->appearance.materials.front();
    Vertex vertex;
    vertex.material = &material;
    struct Row {
        const char* name;
        void (*change)(Shading&, Finish&);
        bool lambertian;
    };
    const Row rows[] = {
        {"plain", [](Shading&, Finish&) {}, true},
        {"phong", [](Shading&, Finish& f) { f.phong = 1; }, true},
        {"mirror", [](Shading&, Finish& f) { f.reflection.greatest = Rgb(1); }, true},
        {"brilliance", [](Shading&, Finish& f) { f.brilliance = 2; }, true},
        {"behind", [](Shading&, Finish& f) { f.diffuse_back = 0.5; }, false},
        {"both sides", [](Shading& s, Finish&) { s.both_sides = true; }, false},
        {"facets", [](Shading&, Finish& f) { f.microfacet.on = true; }, false},
        {"film", [](Shading&, Finish& f) { f.irid.amount = 0.3; }, false},
        {"grain", [](Shading&, Finish& f) { f.crand = 0.3; }, false},
        {"energy", [](Shading&, Finish& f) { f.conserve_energy = true; }, false},
    };
    for (const Row& row : rows) {
        Finish finish;
        Shading s{};
        s.finish = &finish;
        row.change(s, finish);
        CAPTURE(row.name);
        CHECK(is_lambertian(*world, vertex, s) == row.lambertian);
    }
    Finish finish;
    Shading s{};
    s.finish = &finish;
    material.by_view = true;
    CHECK_FALSE(is_lambertian(*world, vertex, s));
}

}  // namespace candelabra
