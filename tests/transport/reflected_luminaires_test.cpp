// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/reflected_luminaires.h"

#include "support/draw.h"
#include "support/scripts.h"
#include "transport/integrator.h"
#include "transport/reflecting_room.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Second moment of the unoccluded light of one choice, over the square of the light of all: 1 if
/// each is chosen by what it lights.
double spread_of_choice(const ReflectedSet& set, const Receiver& at) {
    const BsdfLobes lobes;
    const BuiltLightSampler& sampler = at.horizon == Horizon::none ? set.in_air : set.sampler;
    return std::visit(
        [&](const auto& strategy) {
            const auto answer = strategy.at({at, lobes, nullptr, nullptr});
            double all = 0, squares = 0;
            for (std::uint32_t i = 0; i < set.list.size(); ++i) {
                const Vec3 offset = set.list[i].position - at.position, direction = unit(offset);
                const double there = set.list[i].in_air() ? 1 : -dot(direction, set.list[i].normal),
                             cosines = at.cosine(direction) * there;
                if (!(at.cosine(direction) > 0 && there > 0)) continue;
                const double light = grey(set.list[i].power) *
                                     std::fmin(cosines / dot(offset, offset), set.bounds[i]);
                all += light;
                squares += light * light / answer.expected({3, 5, 0, 0}, i);
            }
            return squares / (all * all);
        },
        sampler);
}

}  // namespace

TEST_CASE("a generation does not depend on the number of threads", "[transport]") {
    const Shot shot = shot_of(with_reflected(3000, 4) + lamps_in_room + bare_room +
                              "light_source { <1, 2, -1>, 1 area_light x, z, 3, 3 jitter } "
                              "light_source { <1, 9, -1>, 1 shadowless } "
                              "sky_sphere { pigment { rgb 1 } luminaire }");
    const auto set = [&](int threads) {
        const auto all = reflected_luminaires_of(shot, 5, threads);
        REQUIRE(all);
        return all->generation(2)->list;
    };
    const auto one = set(1);
    REQUIRE(one.size() > 3000);
    for (const int threads : {2, 7}) {
        const auto other = set(threads);
        REQUIRE(other.size() == one.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            CHECK(other[i].position == one[i].position);
            CHECK(other[i].power == one[i].power);
        }
    }
}

TEST_CASE("reflected luminaires are chosen by what they light, though they stand dense and sparse",
          "[transport]") {
    // Most light is scattered near the lamp, and some far off.
    const Shot shot = shot_of(
        with_reflected(500, 20) +
        "camera { location <0, 4, -10> look_at <0, 1, 0> } box { <-14, -3, -14>, <14, 12, 14> "
        "hollow pigment { rgbt 1 } finish { diffuse 0 } interior { media { scattering { 1, 0.15 "
        "multiple } } } } box { <-13, -1, -13>, <13, 0, 13> pigment { rgb 0.5 } } "
        "sphere { <2, 1, 0>, 0.3 pigment { rgb 1 } finish { diffuse 0 emission 30 } }");
    const auto all = reflected_luminaires_of(shot, 5, 1);
    REQUIRE(all);
    double on_floor = 0, in_air = 0;
    constexpr int count = 60;
    for (int i = 0; i < count; ++i) {
        const auto set = all->generation(static_cast<std::uint32_t>(i) % 3);
        const Vec3 place(-8 + 16 * (i + 0.5) / count, 0, -6 + 12 * (i * 7 % count) / double{count});
        on_floor += spread_of_choice(*set, {place, Vec3(0, 1, 0), Horizon::one_side}) / count;
        in_air += spread_of_choice(*set, {place + Vec3(0, 2, 0), Vec3(0), Horizon::none}) / count;
    }
    CHECK(on_floor < 2);
    CHECK(in_air < 2);
}

TEST_CASE("reflected luminaires are there where a scene asks for them and light is reflected",
          "[transport]") {
    const auto there = [](const std::string& script) {
        return reflected_luminaires_of(shot_of(script), 0, 1) != nullptr;
    };
    CHECK(there(with_reflected(100, 2) + lamps_in_room + bare_room));
    CHECK_FALSE(there(with_reflected(0, 2) + lamps_in_room + bare_room));
    CHECK_FALSE(there(with_reflected(100, 0) + lamps_in_room + bare_room));
    CHECK_FALSE(there(with_reflected(100, 2) + bare_room));
    CHECK(there(with_reflected(100, 2) + bare_room + "light_source { <1, 2, -1>, 1 }"));
    CHECK_FALSE(there(with_reflected(100, 2) + bare_room + "light_source { <1, 2, -1>, 0 }"));
    const std::string yard =
        "camera { location <0, 2, -5> look_at 0 } plane { y, 0 pigment { rgb 1 } } "
        "box { -1, 1 pigment { rgb 1 } } sky_sphere { pigment { rgb 1 } ";
    CHECK(there(with_reflected(100, 2) + yard + "luminaire }"));
    CHECK_FALSE(there(with_reflected(100, 2) + yard + "}"));
    // A single surface, whose light reaches no other.
    CHECK_FALSE(there(with_reflected(100, 2) + lamps_in_room + "plane { y, 0 pigment { rgb 1 } }"));
    CHECK(there(with_reflected(100, 2) + lamps_in_room + bare_room + "fog { distance 9 rgb 0.1 }"));
    const auto beside = [&](const std::string& object) {
        return there(with_reflected(100, 2) + lamps_in_room + bare_room + object);
    };
    const std::string set = "julia_fractal { <-0.1, 0, -0.8, 0> hypercomplex ";
    CHECK(beside(set + "sqr }"));
    CHECK_FALSE(beside(set + "exp }"));
    CHECK_FALSE(beside("union { intersection { sphere { 0, 1 } " + set + "pwr(3, 0) } } }"));
    CHECK(there(with_reflected(100, 2) + lamps_in_room + bare_room +
                "global_settings { photons { count 100 } } sphere { <2, 1, 2>, 0.5 pigment { "
                "rgbt 1 } interior { ior 1.5 } photons { target reflection on } }"));
}

TEST_CASE("light paths are as many as the scene says, or follow the size of the picture",
          "[transport]") {
    const auto count = [](const std::string& said, int size) {
        const Shot shot =
            square_shot(world_of("#version 3.7; global_settings { integrator { path_traced { " +
                                 said + " } } } " + lamps_in_room + bare_room),
                        size);
        return reflected_luminaires_of(shot, 0, 1)->count();
    };
    CHECK(count("reflected_luminaires 700", 32) == 700);
    CHECK(count("reflected_luminaires 700", 640) == 700);
    CHECK(count("", 32) == 500);
    CHECK(count("", 160) == 1600);
    CHECK(count("", 640) == 5000);
}

TEST_CASE("a closed body that glows and reflects is a furnace inside, whatever its shape",
          "[transport]") {
    // L = 0.4 + 0.6 L.
    for (const char* const body :
         {"sphere { 0, 2", "sphere { 0, 2 scale <1, 1.5, 0.8>", "box { -2, 2",
          "box { -2, 2 rotate <10, 20, 30>", "cylinder { -2*y, 2*y, 2", "cone { -2*y, 2, 2*y, 1",
          "superellipsoid { <0.5, 0.5> scale 2", "torus { 2, 1.5 translate 2*x",
          "blob { threshold 0.5 sphere { 0, 3, 1 }",
          "lathe { linear_spline 4 "
          "<0, -2>, <2, -2>, <2, 2>, <0, 2>",
          "sphere_sweep { linear_spline 2, -x, 2, x, 2",
          "mesh { triangle { -2, <2, -2, -2>, <0, -2, 3> } triangle { -2, <2, -2, -2>, 3*y } "
          "triangle { <2, -2, -2>, <0, -2, 3>, 3*y } triangle { <0, -2, 3>, -2, 3*y }",
          "difference { box { -3, 3 } box { -2, 2 }",
          "difference { cylinder { -3*y, 3*y, 3 } cylinder { -2*y, 2*y, 2 }",
          "difference { sphere { 0, 3 } sphere { 0, 2 }",
          "difference { box { -3, 3 } sphere { 0, 2 }",
          "intersection { sphere { 0, 2 } box { -1.7, 1.7 }",
          "merge { box { <-2, -1, -1>, <1, 1, 1> } box { <-1, -2, -1>, <2, 2, 1> }",
          "union { sphere { 0, 2 clipped_by { plane { y, 0.3 } } } "
          "sphere { 0, 2 clipped_by { plane { -y, -0.3 } } }"}) {
        const Shot shot = shot_of(with_reflected(300, 40) + body +
                                  " pigment { rgb 1 } finish { diffuse 0.6 emission 0.4 } }");
        CHECK(reflected_luminaires_of(shot, 0, 1));
        Integrator integrator(shot, {});
        Draw draw(1);
        double sum = 0, squares = 0;
        constexpr std::uint32_t groups = 60;
        Key key;
        for (std::uint32_t group = 0; group < groups; ++group) {
            double seen = 0;  // by the samples of one generation
            for (int i = 0; i < 4; ++i, ++key.sample)
                seen += integrator.radiance({Vec3(0.1, 0.2, 0.3), draw.direction()}, key).r / 4;
            sum += seen, squares += seen * seen;
        }
        const double mean = sum / groups,
                     error = std::sqrt((squares / groups - mean * mean) / groups);
        CAPTURE(body, mean, error);
        CHECK(error < 0.05);
        CHECK(std::abs(mean - 1) < 4 * error + 0.005);
    }
}

TEST_CASE("light paths leave the side of a lamp that glows, and of lamps in one place one",
          "[transport]") {
    // The middle of a floor under a ceiling, which the panel lights from below or not at all.
    const auto lit = [](int paths, const std::string& panel) {
        const Shot shot =
            shot_of(with_reflected(paths, 3) +
                    "box { <-3, 0, -3>, <3, 3, 3> pigment { rgb 0.7 } } "
                    "box { <-0.7, 1.49, -0.7>, <0.7, 1.499, 0.7> pigment { rgb 0 } } " +
                    panel);
        Integrator integrator(shot, {});
        Draw draw(2);
        double sum = 0;
        Key key;
        constexpr std::uint32_t count = 4000;
        for (key.sample = 0; key.sample < count; ++key.sample) {
            const Vec3 from(2.5 * draw.number(), 0.5, 2.5 * draw.number() - 1.2);
            sum += integrator.radiance({from, Vec3(0, -1, 0)}, key).r / count;
        }
        return sum;
    };
    const std::string disc = "disc { 1.5*y, y, 0.6 ", dark = "{ pigment { rgb 0 } } ",
                      glow = "{ pigment { rgb 1 } finish { diffuse 0 emission 8 } } ";
    for (const std::string& panel :
         {disc + "texture " + glow + "}",
          disc + "texture " + glow + "interior_texture " + dark + "}",
          disc + "texture " + dark + "interior_texture " + glow + "}",
          disc + "texture " + glow + "} " + disc + "texture " + glow + "}",
          disc + "texture " + dark + "} " + disc + "texture " + glow + "}"}) {
        CAPTURE(panel);
        const double met = lit(0, panel);
        CHECK(lit(400, panel) == Approx(met).epsilon(0.05).margin(1e-9));
    }
}

}  // namespace candelabra
