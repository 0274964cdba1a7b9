// SPDX-License-Identifier: GPL-3.0-or-later
// Claims of the paper that need a picture or a closed form of their own, and the table of all of
// them (claims.md) against the files that it names.
#include "luminaire/sphere.h"
#include "render/render.h"
#include "support/draw.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <numbers>
#include <regex>
#include <set>
#include <sstream>

namespace candelabra {

namespace {

constexpr int size = 48;

std::string text_of(const std::string& path) {
    std::ifstream file(std::string(CANDELABRA_SOURCE_DIR) + "/" + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Shot shot_with(const std::string& script, const LightSampler& sampler) {
    return square_shot(world_of(scene_of(script), sampler), size);
}

Rendering picture(const Shot& shot, int samples, int seed) {
    RenderSettings settings;
    settings.width = settings.height = size;
    settings.antialias = false;
    settings.samples = samples;
    settings.shadow_rays = 1;
    settings.seed = seed;
    settings.threads = 1;
    return render(shot, settings);
}

/// Root mean square of the noise of the pixels from one column to another.
double noise(const Shot& shot, int samples, int left = 0, int right = size) {
    const Image a = picture(shot, samples, 0).image, b = picture(shot, samples, 1).image;
    double squares = 0;
    for (int y = 0; y < size; ++y)
        for (int x = left; x < right; ++x) {
            const auto i = static_cast<std::size_t>(y * size + x);
            squares += std::pow(grey(a.pixels[i]) - grey(b.pixels[i]), 2) / 2;
        }
    return std::sqrt(squares / (size * (right - left)));
}

const std::string floor_from_above = R"(
    #version 3.7;
    camera { orthographic location <0, 9, 0> look_at 0 right 4*x up 4*y }
    plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }
    #declare LightProxy = texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 40 } }
)";

/// Relative variance of the cosine on the far side, and the share of points that face away.
struct Waste {
    double variance, away;
};
/// Of points of a far sphere whose height towards the receiver is evenly spread: such points are
/// evenly spread over the area (Archimedes).
Waste waste(double lowest) {
    constexpr int steps = 1000000;
    double sum = 0, squares = 0, away = 0;
    for (int i = 0; i < steps; ++i) {
        const double height = lowest + (1 - lowest) * (i + 0.5) / steps;
        const double seen = std::fmax(height, 0);
        sum += seen, squares += seen * seen, away += height < 0;
    }
    return {squares * steps / (sum * sum) - 1, away / steps};
}

}  // namespace

TEST_CASE("of a far sphere's area half is wasted, of its cone nothing", "[statistics][claim-2]") {
    const Waste whole = waste(-1), visible = waste(0);
    CHECK(whole.variance == Approx(5.0 / 3).epsilon(0.02));
    CHECK(whole.away == Approx(0.5).epsilon(0.02));
    CHECK(visible.variance == Approx(1.0 / 3).epsilon(0.02));
    Draw draw(1);
    const SphereEmitter sphere{Vec3(0, 1000, 0), 1};
    const double solid_angle = std::numbers::pi * 1e-6;
    for (int i = 0; i < 1000; ++i) {
        const auto drawn = sample(sphere, Vec3(0), Vec2{draw.number(), draw.number()});
        REQUIRE(drawn.has_value());
        CHECK(1 / drawn->density == Approx(solid_angle).epsilon(1e-5));
        CHECK(dot(drawn->position - sphere.centre, drawn->direction) < 0);
    }
}

TEST_CASE("linear alpha beats constant alpha where one lamp is near", "[statistics][claim-4]") {
    const std::string lamps = floor_from_above + R"(
        sphere { <0, 0.6, 0>, 0.05 texture { LightProxy } no_image }
        sphere { <6, 5, 0>, 0.05 texture { LightProxy } no_image })";
    const Shot constant = shot_with(lamps, ConstantAlpha{}),
               linear = shot_with(lamps, LinearAlpha{}), every = shot_with(lamps, EveryLight{});
    CHECK(noise(linear, 1) * 3 < noise(constant, 1));
    CHECK(noise(constant, 16) < noise(constant, 1) / 3.5);
    CHECK(noise(every, 1) < noise(constant, 1));
    CHECK(picture(every, 4, 0).rays.shadow == 2 * picture(linear, 4, 0).rays.shadow);
}

TEST_CASE("the noise of one lamp is in its penumbra", "[statistics][claim-8]") {
    const Shot shot = shot_with(floor_from_above + R"(
        sphere { <0, 3, 0>, 0.5 texture { LightProxy } no_image }
        box { <0.6, 1, -9>, <9, 1.05, 9> pigment { rgb 0 } no_image })",
                                LinearAlpha{});
    const double lit = noise(shot, 4, 0, 16), shadow = noise(shot, 4, 24, 48);
    CAPTURE(lit, shadow);
    CHECK(lit < 1e-3);
    CHECK(shadow > 20 * lit);
}

TEST_CASE("imposters light like what they stand for", "[statistics][claim-25]") {
    // In a closed white box whose walls send out 1/(1 - 0.6) each, reflected light included, the
    // floor sends on 0.6 of that when the walls are replaced by emitters that reflect nothing.
    const std::string walls = R"(
        #version 3.7;
        camera { orthographic location <0, 0.9, 0> look_at 0 right 1.9*x up 1.9*y }
        #declare Wall = texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 2.5 } }
        box { <-1, -1.1, -1>, <1, -1, 1> pigment { rgb 1 } finish { ambient 0 diffuse 0.6 } }
        #for (I, 0, 7) #for (J, 0, 7)
            #declare A = -1 + I/4; #declare B = -1 + J/4;
            box { <A, 1, B>, <A + 0.25, 1.01, B + 0.25> texture { Wall } }
            box { <A, B, 1>, <A + 0.25, B + 0.25, 1.01> texture { Wall } }
            box { <A, B, -1.01>, <A + 0.25, B + 0.25, -1> texture { Wall } }
            box { <1, A, B>, <1.01, A + 0.25, B + 0.25> texture { Wall } }
            box { <-1.01, A, B>, <-1, A + 0.25, B + 0.25> texture { Wall } }
        #end #end)";
    const Image image = picture(shot_with(walls, LightOctree{}), 16, 0).image;
    double sum = 0;
    for (const Rgb& pixel : image.pixels) sum += grey(pixel);
    CHECK(sum / (size * size) == Approx(0.6 * 2.5).epsilon(0.01));
}

TEST_CASE("each claim is where the table says", "[statistics]") {
    const std::string table = text_of("tests/statistics/claims.md");
    const std::regex row(R"(\n\| (\d+) \| [^|]+ \| (\S+) \|)");
    std::set<int> rows;
    for (std::sregex_iterator i(table.begin(), table.end(), row), end; i != end; ++i) {
        const std::string number = (*i)[1], file = (*i)[2];
        INFO("claim " << number << " in " << file);
        CHECK(text_of(file).find("[claim-" + number + "]") != std::string::npos);
        rows.insert(std::stoi(number));
    }
    CHECK(rows.size() == 34);
    CHECK((!rows.empty() && *rows.begin() == 1 && *rows.rbegin() == 34));
}

}  // namespace candelabra
