// SPDX-License-Identifier: GPL-3.0-or-later
// A luminaire that outshines all others: hidden it must make next to no noise, and where it comes
// through a gap all of its light must arrive.
#include "render/render.h"

#include "support/scripts.h"
#include "text/message.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr int sunlit_size = 48;

Shot sunlit_room(double sun, double gap, const LightSampler& sampler) {
    return shot_of_file("tests/bench/sun.pov", {{"Sun", sun}, {"Gap", gap}}, sampler, sunlit_size);
}

Image sunlit_picture(const Shot& shot, int samples, int seed) {
    RenderSettings settings;
    settings.width = settings.height = sunlit_size;
    settings.antialias = false;
    settings.samples = samples;
    settings.shadow_rays = 1;
    settings.seed = seed;
    return render(shot, settings).image;
}

double rmse(const Shot& shot) {
    const Image a = sunlit_picture(shot, 16, 0), b = sunlit_picture(shot, 16, 1);
    double squares = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        squares += std::pow(grey(a.pixels[i]) - grey(b.pixels[i]), 2) / 2;
    return std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

double mean(const Image& image) {
    double sum = 0;
    for (const auto& pixel : image.pixels) sum += grey(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("a hidden sun makes little more noise than none", "[statistics][claim-27]") {
    const double without = rmse(sunlit_room(0, 0, LightOctree{})),
                 with = rmse(sunlit_room(1, 0, LightOctree{}));
    CAPTURE(without, with);
    CHECK(without > 0.001);
    CHECK(with < 1.25 * without);
}

TEST_CASE("long double rows of lamps give all their light, without outliers", "[statistics]") {
    for (const int pairs : {200, 500, 2000}) {
        const std::string street = message(
            "#version 3.7; #default { finish { ambient 0 } } "
            "camera { location <0, 3, -4> look_at <0, 0, 12> angle 50 } "
            "plane { y, 0 pigment { rgb 0.4 } } #for (I, 0, ",
            pairs - 1,
            ") #for (Side, -1, 1, 2) sphere { <2.5*Side, 4, 6*I>, 0.12 no_image "
            "finish { diffuse 0 emission 40 } pigment { rgb 1 } } #end #end");
        const auto seen = [&](const LightSampler& sampler, int samples) {
            const SharedWorld world = world_of(scene_of(street), sampler);
            return sunlit_picture(square_shot(world, sunlit_size), samples, 0);
        };
        const Image exact = seen(LightBvh{}, 64), found = seen(LightOctree{}, 16);
        const auto brightest = [](const Image& image) {
            double most = 0;
            for (const auto& pixel : image.pixels) most = std::fmax(most, grey(pixel));
            return most;
        };
        CAPTURE(pairs, mean(found), mean(exact), brightest(found), brightest(exact));
        CHECK(mean(found) == Approx(mean(exact)).epsilon(0.02));
        CHECK(brightest(found) < 1.5 * brightest(exact));
    }
}

TEST_CASE("a sun that comes through a gap gives all its light", "[statistics]") {
    const double exact = mean(sunlit_picture(sunlit_room(1, 0.1, EveryLight{}), 4, 0));
    const Shot shot = sunlit_room(1, 0.1, LightOctree{});
    constexpr int runs = 16;
    double sum = 0, squares = 0;
    for (int seed = 0; seed < runs; ++seed) {
        const double found = mean(sunlit_picture(shot, 8, seed)) / exact;
        sum += found;
        squares += found * found;
    }
    const double found = sum / runs, variance = (squares / runs - found * found) / (runs - 1);
    CAPTURE(exact, found, variance);
    CHECK(exact > 1);
    CHECK(std::abs(found - 1) < 4.5 * std::sqrt(variance) + 1e-3);
    CHECK(variance < 0.01);
}

TEST_CASE("spheres of which nothing hides any make no noise", "[statistics][claim-3][claim-7]") {
    // Figure 2 from nearer by: the floor between four spheres of equal power. Each is sampled by
    // projected solid angle, and the choice among them is exact.
    const Shot shot = shot_of(R"(#version 3.7;
        global_settings { assumed_gamma 1 }
        camera { location <0, 0.9, 0> look_at <0, 0, 0> sky z right x up y angle 60 }
        plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }
        #declare Radii = array[4] { 0.08, 0.25, 0.5, 0.8 };
        #for (I, 0, 3)
            sphere {
                <(mod(I, 2) - 0.5)*4, 1, (0.5 - div(I, 2))*4>, Radii[I] pigment { rgb 1 }
                finish { ambient 0 diffuse 0 emission 60/pow(2*pi*Radii[I], 2) }
            }
        #end)");
    const Image a = sunlit_picture(shot, 1, 0), b = sunlit_picture(shot, 1, 1);
    double worst = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        worst = std::fmax(worst, std::abs(grey(a.pixels[i]) / grey(b.pixels[i]) - 1));
    CHECK(mean(a) > 0.1);
    CHECK(worst < 1e-3);
}

}  // namespace candelabra
