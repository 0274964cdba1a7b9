// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/falloff.h"

#include "support/draw.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Falloff any_falloff(Draw& draw) {
    Falloff f;
    if (draw.number() < 0.5) {
        f.fade_distance = draw.between(0.1, 5);
        f.fade_power = draw.between(0.1, 5);
    }
    if (draw.number() < 0.8) {
        f.axis = draw.direction();
        f.dark = draw.between(0.05, 1.57);
        f.bright = draw.between(0, f.dark);
    }
    return f;
}

}  // namespace

TEST_CASE("light that does not fade undoes the square law, other light fades besides",
          "[luminaire]") {
    CHECK(against_square_law({}, Vec3(0, 3, 0), 0) == Approx(9));
    CHECK(against_square_law({}, Vec3(0, 3, 0), 5) == Approx(25));
    for (const double power : {1.0, 2.0, 7.5})
        for (const double distance : {0.5, 2.0, 8.0})
            CHECK(against_square_law({2, power}, Vec3(distance, 0, 0), 0) ==
                  Approx(distance * distance * 2 / (1 + std::pow(distance / 2, power))));
}

TEST_CASE("a cone lights what lies in it", "[luminaire]") {
    Falloff f;
    f.axis = Vec3(0, -1, 0);
    f.dark = 0.7;
    f.bright = 0.3;
    const auto at = [&](double angle, double radius) {
        return against_square_law(f, Vec3(std::sin(angle), std::cos(angle), 0), radius);
    };
    CHECK(at(0, 0) == Approx(1));
    CHECK(at(0.29, 0) == Approx(1).epsilon(1e-3));
    CHECK(at(0.5, 0) > 0.2);
    CHECK(at(0.5, 0) < 0.8);
    CHECK(at(0.71, 0) == 0);
    CHECK(at(0.71, 0.1) > 0);
    CHECK(at(3, 1.1) == Approx(1.21));
}

TEST_CASE("what is joined is nowhere dark where one of its parts is not", "[luminaire]") {
    Draw draw(1);
    int lit = 0;
    for (int i = 0; i < 100000; ++i) {
        const Falloff parts[] = {any_falloff(draw), any_falloff(draw), any_falloff(draw)};
        const Falloff all = join(join(parts[0], parts[1]), parts[2]);
        const Vec3 middle = draw.point(3), point = draw.point(10);
        constexpr double radius = 1;
        for (const Falloff& part : parts) {
            const Vec3 place = middle + radius * draw.number() * draw.direction();
            if (!(against_square_law(part, place - point, 1e-6) > 0)) continue;
            ++lit;
            const double joined = against_square_law(all, middle - point, radius);
            if (!(joined > 0)) CHECK(joined > 0);
        }
    }
    CHECK(lit > 20000);
}

}  // namespace candelabra
