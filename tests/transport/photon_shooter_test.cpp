// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_shooter.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>
#include <numbers>

namespace candelabra {

namespace {

using std::numbers::pi;

Shot shooting_at_ball(const std::string& lamp) {
    return shot_of(
        R"(#version 3.7; #default { pigment { rgb 1 } } global_settings { photons { count 1000 } }
        sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 }
                 photons { target refraction on reflection on } } )" +
        lamp);
}

/// Power that arrives at the ball of radius 1 around 0, whatever else the photons meet first: mean
/// and standard error.
struct Arriving {
    double power = 0, error = 0;
    int missed = 0;
};
Arriving arriving(const Shot& shot, std::uint32_t count = 1 << 14) {
    const PhotonShooter shooter(shot);
    Arriving result;
    for (std::size_t i = 0; i < shooter.aims().size(); ++i) {
        double sum = 0, squares = 0;
        for (std::uint32_t n = 0; n < count; ++n) {
            const auto shot =
                shooter.shoot(shooter.aims()[i], {7, n, static_cast<std::uint32_t>(i), 0});
            if (!shot) continue;
            const double away = dot(-shot->ray.origin, shot->ray.direction);
            const Vec3 nearest = shot->ray.at(away);
            if (length(nearest) > 1 + 1e-6) ++result.missed;
            const double power = shot->power_after(std::fmax(away, 0)).r;
            sum += power;
            squares += power * power;
        }
        result.power += sum / count;
        result.error += (squares / count - sum * sum / count / count) / count;
    }
    result.error = std::sqrt(result.error);
    return result;
}

}  // namespace

TEST_CASE("a point light gives a ball what its cone holds, at any distance", "[transport]") {
    for (const double far : {2.0, 10.0}) {
        const Arriving found = arriving(
            shooting_at_ball("light_source { <0, " + std::to_string(far) + ", 0>, rgb 3 }"));
        const double steradians = 2 * pi * (1 - std::sqrt(1 - 1 / (far * far)));
        // Photons that end in the plane through the centre travel distance / cosine.
        CHECK(found.power >= 3 * steradians * far * far * (1 - 1 / (far * far)) * 0.999);
        CHECK(found.power <= 3 * steradians * far * far * 1.001);
        CHECK(found.missed == 0);
    }
}

TEST_CASE("parallel light gives a ball what its shadow takes", "[transport]") {
    CHECK(arriving(shooting_at_ball("light_source { 9*y, rgb 3 parallel point_at 0 }")).power ==
          Approx(3 * pi).epsilon(1e-6));
    // A narrower beam through the centre.
    CHECK(arriving(shooting_at_ball("light_source { 9*y, rgb 3 cylinder point_at 0 radius 0.5 "
                                    "falloff 0.50001 }"))
              .power == Approx(3 * pi / 4).epsilon(1e-3));
}

TEST_CASE("a cone that is narrower than a target is aimed by itself", "[transport]") {
    const Arriving found = arriving(shooting_at_ball(
        "light_source { 9*y, rgb 3 spotlight point_at 0 radius 2 falloff 2.0001 }"));
    const double steradians = 2 * pi * (1 - std::cos(2 * pi / 180));
    CHECK(found.power == Approx(3 * steradians * 81).epsilon(2e-3));
    CHECK(PhotonShooter(shooting_at_ball("light_source { 9*y, rgb 3 spotlight point_at 18*y } "
                                         "light_source { 9*y, rgb 1 }"))
              .aims()
              .size() == 1);
}

TEST_CASE("luminaires give a ball what they send there", "[transport]") {
    // Power from one ball to another, far away: pi L times the area of the first one's shadow times
    // the solid angle of the second; as a colour of light, this is divided by pi.
    const Arriving ball = arriving(shooting_at_ball("sphere { 50*y, 2 finish { emission 3 } }"));
    const double far = 3 * (pi * 4) * (pi / (50 * 50)) / pi;
    CHECK(ball.power == Approx(far).epsilon(0.01));
    CHECK(ball.missed == 0);
    // A ball around the target: all light that leaves it inwards and through the target.
    const Arriving around =
        arriving(shooting_at_ball("sphere { 0, 5 hollow pigment { rgb 1 } finish { emission 3 } }"),
                 1 << 16);
    CHECK(around.power == Approx(3 * 4 * pi).epsilon(0.02));
}

TEST_CASE("many lamps are as good as their sum", "[transport]") {
    const std::string lamps = R"(
        #for (I, 0, 199)
            sphere { <mod(I, 20)*2 - 19, 6, floor(I/20)*2 - 9>, 0.05 finish { emission 30 } }
        #end)";
    const Shot shot = shooting_at_ball(lamps);
    double expected = 0;
    for (int i = 0; i < 200; ++i) {
        const Vec3 place(i % 20 * 2 - 19, 6, i / 20 * 2 - 9);
        const double away2 = dot(place, place);
        expected += 30 * 0.05 * 0.05 * 2 * pi * (1 - std::sqrt(1 - 1 / away2));
    }
    const Arriving found = arriving(shot);
    CHECK(std::abs(found.power - expected) < 4 * found.error + 0.002 * expected);
    CHECK(found.error < 0.02 * expected);
}

TEST_CASE("a lamp in a target shoots all around", "[transport]") {
    // The lamp is in a glass ball; half of a disc's light goes to each side.
    const Arriving found = arriving(
        shooting_at_ball("disc { 0, y, 0.1 pigment { rgb 1 } finish { emission 3 } }"), 1 << 15);
    CHECK(found.power == Approx(2 * 3 * pi * 0.01).epsilon(0.01));
}

TEST_CASE("the number of photons follows from their spacing", "[transport]") {
    const std::string light = "light_source { 9*y, rgb 1 parallel point_at 0 } ";
    const auto count = [&](const std::string& settings, const std::string& target = "target") {
        const Shot shot =
            shot_of("#version 3.7; #default { pigment { rgb 1 } } global_settings { photons { " +
                    settings + " } } sphere { 0, 1 pigment { rgbt 1 } photons { refraction on " +
                    target + " } } " + light);
        return PhotonShooter(shot).count();
    };
    CHECK(count("count 500 spacing 1") == 500);
    CHECK(count("spacing 0.1") == 314);
    CHECK(count("spacing 0.1", "target 0.5") == 1256);
    CHECK(count("spacing 1e-9") == 262144);
}

}  // namespace candelabra
