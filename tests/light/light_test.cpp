// SPDX-License-Identifier: GPL-3.0-or-later
#include "light/light.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a light fades as POV-Ray 3.7's", "[light]") {
    struct Case {
        double fade_distance, fade_power, distance, share;
    };
    const Case cases[] = {{0, 2, 5, 1},
                          {3, 0, 5, 1},
                          {3, 2, 3, 1},
                          {3, 2, 6, 0.4},
                          {3, 1, 0, 2},
                          {2, 4, 4, 2.0 / 17},
                          // As if the points were behind the light.
                          {-4, 2, 7, 2 / (1 + 49.0 / 16)},
                          {-9, 1, 7, 9},
                          {-4, 1, 7, -8.0 / 3},
                          {-4, 1.5, 7, 0},
                          {-4, 1, 4, 0}};
    for (const Case& c : cases) {
        PointLight light;
        light.fade_distance = c.fade_distance;
        light.fade_power = c.fade_power;
        light.location = Vec3(0, c.distance, 0);
        light.colour = Rgb(1);
        if (c.distance > 0)
            CHECK(incidence(light, light.location, Vec3(0)).colour.r == Approx(c.share));
    }
}

TEST_CASE("a light fades from its source on as POV-Ray 3.8's", "[light]") {
    PointLight light;
    light.fades_from_source = true;
    light.colour = Rgb(1);
    const auto at = [&](double distance, double power) {
        light.fade_power = power;
        return incidence(light, Vec3(0, distance, 0), Vec3(0)).colour.r;
    };
    CHECK(at(1, 2) == 1);
    CHECK(at(2, 2) == Approx(0.25));
    CHECK(at(0.5, 3) == Approx(8));
    CHECK(at(3, 0) == 1);
    light.fade_distance = 3;
    CHECK(at(6, 2) == Approx(0.4));
}

TEST_CASE("beams are bright in the middle and end at their falloff", "[light]") {
    PointLight light;
    light.colour = Rgb(1);
    light.location = Vec3(0, 0, -5);
    light.point_at = Vec3(0);
    const auto at = [&](double x) {
        return incidence(light, light.location, Vec3(x, 0, 0)).colour.r;
    };
    light.beam = cone;
    CHECK(at(1) == 1);
    CHECK(at(3.5) == Approx(0.79096).margin(1e-4));
    CHECK(at(5.2) == 0);
    light.beam = parallel_beam;
    CHECK(at(0.5) == 1);
    CHECK(at(0.9) == Approx(0.352));
    CHECK(at(1.01) == 0);
    CHECK(incidence(light, light.location, Vec3(0.9, 0, 0)).direction == Vec3(0, 0, -1));
}

TEST_CASE("a settled cone gives the same light, and none beside it", "[light]") {
    for (const auto& [radius, falloff] :
         {std::pair{5.0, 9.0}, {30.0, 45.0}, {40.0, 20.0}, {95.0, 100.0}, {70.0, 110.0}}) {
        PointLight light;
        light.beam = cone;
        light.colour = Rgb(1, 2, 3);
        light.location = Vec3(1, 2, 3);
        light.point_at = Vec3(-1, 0, 2);
        light.radius = radius;
        light.falloff = falloff;
        PointLight settled = light;
        settle(settled);
        int beside = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 point(i % 10 - 4.5, i / 10 % 10 - 4.5, i / 100 - 4.5);
            const Rgb colour = incidence(light, light.location, point).colour;
            CHECK(incidence(settled, light.location, point).colour == colour);
            CHECK_FALSE(is_beside_cone(light, point));
            if (!is_beside_cone(settled, point)) continue;
            ++beside;
            CHECK(colour == Rgb(0));
        }
        CHECK(beside > 100);
    }
}

TEST_CASE("each light of a parallel grid has an axis of its own", "[light]") {
    PointLight light;
    light.colour = Rgb(1);
    light.location = Vec3(0, 10, 0);
    light.point_at = Vec3(0);
    light.parallel = true;
    const Incidence off = incidence(light, Vec3(2, 10, 0), Vec3(50, 1, 7));
    CHECK(length(off.direction - unit(Vec3(2, 10, 0))) < 1e-12);
    CHECK(incidence(light, light.location, Vec3(50, 1, 7)).direction == Vec3(0, 1, 0));
}

TEST_CASE("a light without shadows keeps to no cone and no cylinder, as POV-Ray's", "[light]") {
    PointLight light;
    light.colour = Rgb(1);
    light.location = Vec3(0, 0, -5);
    light.point_at = Vec3(0);
    light.shadowless = true;
    CHECK(ignored(light).empty());
    for (const int beam : {cone, parallel_beam}) {
        light.beam = beam;
        const Incidence far = incidence(light, light.location, Vec3(20, 0, 0));
        CHECK(far.colour == Rgb(1));
        CHECK((far.direction == Vec3(0, 0, -1)) == (beam == parallel_beam));
        CHECK_FALSE(ignored(light).empty());
    }
}

TEST_CASE("the grid of an area light has its corners at its sides", "[light]") {
    PointLight light;
    light.area1 = Vec3(4, 0, 0);
    light.area2 = Vec3(0, 2, 0);
    light.size1 = 5;
    light.size2 = 1;
    CHECK(light.is_area());
    CHECK(grid_point(light, 0, 0, Vec3(0, 0, 1)) == Vec3(-2, 0, 0));
    CHECK(grid_point(light, 4, 0, Vec3(0, 0, 1)) == Vec3(2, 0, 0));
    light.size2 = 5;
    light.circular = true;
    CHECK(length(grid_point(light, 0, 0, Vec3(0, 0, 1)) / Vec3(2, 1, 1)) < 1.01);
}

}  // namespace candelabra
