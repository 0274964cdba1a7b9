// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include "support/scripts.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace candelabra {

namespace {

const char* const four_lamps = R"(
    #version 3.7;
    camera { location <0, 3, -8> look_at <0, 1, 0> right x up y angle 50 }
    plane { y, 0 pigment { checker rgb 0.9, rgb 0.4 } finish { ambient 0 diffuse 0.8 } }
    sphere { <0, 1, 0>, 1 pigment { rgb 0.6 } finish { ambient 0 diffuse 0.7 reflection 0.2 } }
    #for (I, 0, 11)
        sphere { <2, 0.4, 0>, 0.2 rotate 30*I*y pigment { rgb <1, 0.8, 0.5> } finish { diffuse 0 emission 6 } }
    #end
)";

RenderSettings small(int threads) {
    RenderSettings settings;
    settings.width = 45;
    settings.height = 37;
    settings.threads = threads;
    return settings;
}

/// A lamp whose edge must not be moved by any pixel filter, on an evenly lit ground.
World filmed(const std::string& film) {
    return world_of(R"(
        #version 3.7;
        camera { location -5*z right x up y film { )" +
                    film + R"( } }
        sphere { 0, 1.2 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 0.8 } }
        plane { z, 2 pigment { rgb 1 } finish { ambient 0.3 diffuse 0 } }
    )");
}

RenderSettings of_samples(int samples) {
    RenderSettings settings;
    settings.width = settings.height = 32;
    settings.samples = samples;
    return settings;
}

double mean_grey(const Image& image) {
    double sum = 0;
    for (const Vec3& pixel : image.pixels) sum += pixel.x;
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace

TEST_CASE("a picture begins where one points, and is the same", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(1);
    settings.width = settings.height = 64;
    settings.samples = 1;
    const RenderPlan plan = plan_of(world, settings);
    RenderHooks hooks;
    hooks.first = Vec2(50, 40);
    std::atomic<int> asked = 0;
    RenderState state = begin_picture(settings);
    LightLedger rays;
    hooks.cancelled = [&] { return ++asked > 5; };
    CHECK_FALSE(advance(plan, state, rays, hooks));
    CHECK(state.film.at(50, 33).samples == 1);
    CHECK(state.film.at(3, 3).samples == 0);
    hooks.cancelled = {};
    CHECK(advance(plan, state, rays, hooks));
    CHECK(state.film.image().pixels == render(world, settings).image.pixels);
}

TEST_CASE("the picture has the same bytes for any number of threads", "[render]") {
    const World world = world_of(four_lamps);
    const Rendering one = render(world, small(1));
    for (const int threads : {2, 7}) {
        const Rendering many = render(world, small(threads));
        CHECK(many.image.pixels == one.image.pixels);
        CHECK(many.rays.shadow == one.rays.shadow);
    }
}

TEST_CASE("another seed gives other noise around the same mean", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(0);
    settings.samples = 64;
    const Image first = render(world, settings).image;
    settings.seed = 1;
    const Image second = render(world, settings).image;
    CHECK(first.pixels != second.pixels);
    double sum1 = 0, sum2 = 0;
    for (std::size_t i = 0; i < first.pixels.size(); ++i) {
        sum1 += grey(first.pixels[i]);
        sum2 += grey(second.pixels[i]);
    }
    CHECK(sum1 == Approx(sum2).epsilon(0.01));
}

TEST_CASE("samples are as many as asked for", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(0);
    settings.samples = 3;
    CHECK(render(world, settings).rays.camera == 3u * 45 * 37);
    const World dark = world_of("sphere { <0, 0, 5>, 1 }");
    settings.samples = 0;
    settings.antialias = false;
    CHECK(render(dark, settings).rays.camera == 45u * 37);
}

TEST_CASE("the adaptive scheme has no bias", "[render][statistics]") {
    // Small bright objects that few rays hit would bias a scheme that uses a pixel's own samples.
    const World world = world_of(R"(
        camera { orthographic location <0, 0, -9> right 10*x up 10*y }
        #declare R = seed(1);
        #for (I, 1, 150)
            sphere { <10*rand(R) - 5, 10*rand(R) - 5, 0>, 0.02 + 0.05*rand(R) pigment { rgb 1 } finish { ambient 1 diffuse 0 } }
        #end
        sphere { <0, 0, 99>, 1 pigment { rgb 1 } finish { emission 1 } }  // leaves light to chance
    )");
    RenderSettings settings;
    settings.width = settings.height = 24;
    settings.samples = 2000;
    const auto mean = [&] {
        double sum = 0;
        for (const Vec3& pixel : render(world, settings).image.pixels) sum += pixel.x;
        return sum / (24 * 24);
    };
    const double exact = mean();
    settings.samples = 0;
    double sum = 0, squares = 0;
    const int runs = 40;
    for (settings.seed = 1; settings.seed <= runs; ++settings.seed) {
        const double m = mean();
        sum += m;
        squares += m * m;
    }
    const double average = sum / runs;
    const double error = std::sqrt((squares / runs - average * average) / (runs - 1));
    CHECK(std::abs(average - exact) < 4 * error + 1e-4);
}

TEST_CASE("a picture that is stopped and continued again and again is the same", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(2);
    RenderState whole = begin_picture(settings), broken = whole;
    LightLedger rays;
    CHECK(advance(plan_of(world, settings), whole, rays, {}));
    std::atomic<int> asked = 0;
    RenderHooks hooks;
    int stops = 0, next = 40;
    hooks.cancelled = [&] { return ++asked > next; };
    while (!advance(plan_of(world, settings), broken, rays, hooks)) {
        asked = 0;
        next = 40 + 61 * (++stops % 5);
        REQUIRE(stops < 1000);
    }
    CHECK(stops > 3);
    CHECK(broken == whole);
}

TEST_CASE("a sample that takes too long ends when it is asked to, and is not counted", "[render]") {
    const std::vector<std::string> slow = {
        R"(global_settings { max_trace_level 256 adc_bailout 0 } light_source { <3, 4, -5>, 1 }
           sphere { 0, 1 pigment { rgbt 1 } finish { reflection 1 } interior { ior 1.2 } }
           box { -9, 9 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } })",
        R"(#declare F = function(x) { sum(i, 1, 3000, sum(j, 1, 3000, sin(i*j*x))) }
           plane { z, 1 pigment { average pigment_map { [1 function { F(x) }] [1 function { F(y) }] } } })",
        R"(#declare F = function(x) { sum(i, 1, 3000, sum(j, 1, 3000, sin(i*j*x)*1e-9)) }
           isosurface { function { x*x + y*y + z*z - 1 + F(x) } contained_by { box { -2, 2 } } })",
        R"(blob { threshold 0.5 #for (I, 1, 20000) sphere { sin(I)*0.2, 1, 0.01 } #end })",
    };
    for (const std::string& scene : slow) {
        INFO(scene);
        const World world = world_of("#version 3.7; camera { location -3*z angle 10 } " + scene);
        RenderSettings settings = of_samples(1);
        settings.width = settings.height = 2;
        settings.threads = 1;
        RenderState state = begin_picture(settings, 0);
        LightLedger rays;
        int asked = 0;
        RenderHooks hooks;
        hooks.ended = [&] { return ++asked > 1; };
        CHECK_FALSE(advance(plan_of(world, settings), state, rays, hooks));
        CHECK(asked == 2);
        CHECK(state.film.at(0, 0).samples == 0);
    }
}

TEST_CASE("antialiased pictures can be stopped, and made in parts", "[render]") {
    const World world = world_of(R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { location -5*z look_at 0 }
        light_source { <3, 5, -9>, .9 }
        sphere { 0, 1.3 pigment { checker rgb .9 rgb .2 scale .4 } finish { reflection .2 } })");
    RenderSettings settings = small(2);
    settings.width = 70;
    settings.height = 45;
    settings.sampling_method = GENERATE(1, 2);
    CAPTURE(settings.sampling_method);
    RenderHooks hooks;
    hooks.aovs = {true, true, true};
    RenderState whole = begin_picture(settings, hooks.aovs.count(world)), broken = whole,
                parts = whole;
    LightLedger rays;
    CHECK(advance(plan_of(world, settings), whole, rays, hooks));
    for (int i = 0; i < 3; ++i) {
        RenderState part = begin_picture(settings, hooks.aovs.count(world));
        part.shard.first_tile = i;
        part.shard.tile_step = 3;
        CHECK(advance(plan_of(world, settings), part, rays, hooks));
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x)
                if (part.shard.owns(x, y)) parts.film.add(part.film.index(x, y), part.film);
    }
    CHECK(parts.film.image().pixels == whole.film.image().pixels);
    for (int edge = 34; edge < 42; ++edge) {
        RenderState part = begin_picture(settings, hooks.aovs.count(world));
        part.shard.region = {13, 9, edge, edge};
        CHECK(advance(plan_of(world, settings), part, rays, hooks));
        int others = 0;
        for (int y = 9; y < edge; ++y)
            for (int x = 13; x < edge; ++x)
                others += part.film.at(x, y).mean() != whole.film.at(x, y).mean();
        CHECK(others == 0);
    }
    std::atomic<int> asked = 0;
    hooks.cancelled = [&] { return ++asked > 30; };
    int stops = 0;
    for (; !advance(plan_of(world, settings), broken, rays, hooks); ++stops) {
        asked = 0;
        REQUIRE(stops < 1000);
    }
    CHECK(stops > 3);
    CHECK(broken == whole);
}

TEST_CASE("samples of one picture can be taken in parts and added", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(2);
    settings.samples = 5;
    LightLedger rays;
    RenderState whole = begin_picture(settings);
    advance(plan_of(world, settings), whole, rays, {});
    Film sum(settings.width, settings.height);
    for (const auto& [first, count] : {std::pair{3u, 2}, std::pair{0u, 1}, std::pair{1u, 2}}) {
        settings.samples = count;
        RenderState part = begin_picture(settings);
        part.shard.first_sample = first;
        advance(plan_of(world, settings), part, rays, {});
        for (std::size_t i = 0; i < sum.pixels().size(); ++i)
            sum.pixels()[i].add(part.film.pixels()[i]);
    }
    CHECK(sum.image().pixels == whole.film.image().pixels);
}

TEST_CASE("a picture with photons has the same bytes however it is made", "[render]") {
    const World world = world_of(R"(
        #version 3.7;
        global_settings { photons { count 1500 } radiosity { } }
        camera { location <0, 3, -8> look_at <0, 1, 0> right x up y angle 50 }
        light_source { <5, 9, 1>, rgb 0.5 photons { refraction on } }
        plane { y, 0 pigment { rgb 0.9 } }
        sphere { <0, 1, 0>, 1 pigment { rgbt 1 } interior { ior 1.5 } photons { target refraction on } }
        #for (I, 0, 11)
            sphere { <2, 2.4, 0>, 0.2 rotate 30*I*y pigment { rgb <1, 0.8, 0.5> } finish { emission 6 } }
        #end)");
    RenderSettings settings = small(1);
    settings.samples = 20;
    LightLedger rays;
    RenderState whole = begin_picture(settings), broken = whole;
    advance(plan_of(world, settings), whole, rays, {});
    settings.threads = 3;
    std::atomic<int> asked = 0;
    RenderHooks hooks;
    hooks.cancelled = [&] { return ++asked > 200; };
    for (int stops = 0; !advance(plan_of(world, settings), broken, rays, hooks); ++stops) {
        asked = 0;
        REQUIRE(stops < 1000);
    }
    CHECK(broken == whole);
    Film sum(settings.width, settings.height);
    for (const auto& [first, count] : {std::pair{18u, 2}, std::pair{0u, 5}, std::pair{5u, 13}}) {
        settings.samples = count;
        RenderState part = begin_picture(settings);
        part.shard.first_sample = first;
        advance(plan_of(world, settings), part, rays, {});
        for (std::size_t i = 0; i < sum.pixels().size(); ++i)
            sum.pixels()[i].add(part.film.pixels()[i]);
    }
    CHECK(sum.image().pixels == whole.film.image().pixels);
}

TEST_CASE("lights are counted by statement when that is asked for, the same by any threads",
          "[render]") {
    const World world = world_of(four_lamps + std::string("light_source { 5*y, 0.1 }"));
    REQUIRE(world.provenance.light_statements.size() == 2);
    RenderHooks hooks;
    hooks.counts_lights = true;
    const LightLedger one = render(world, small(1), hooks).rays,
                      three = render(world, small(3), hooks).rays;
    REQUIRE(one.lights.size() == 3);
    std::uint64_t rays = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(one.lights[i].light == three.lights[i].light);
        CHECK(one.lights[i].rays == three.lights[i].rays);
        rays += one.lights[i].rays;
    }
    CHECK(rays == one.shadow);
    CHECK(one.lights[world.provenance.statement_of_light[0]].light.value() > 0);
    CHECK(one.lights[world.provenance.statement_of_luminaire[0]].light.value() > 0);
    CHECK(render(world, small(1)).rays.lights.empty());
}

TEST_CASE("a round winds down once, before its last tile is done", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(1);
    settings.samples = 5;  // several passes over the tiles; only the last winds down
    RenderState state = begin_picture(settings);
    LightLedger rays;
    int winds_down = 0;
    double done = 0;
    RenderHooks hooks;
    hooks.progress = [&](double share) { done = share; };
    hooks.winds_down = [&] {
        ++winds_down;
        CHECK(done > 0.5);
        CHECK(done < 1);
    };
    CHECK(advance(plan_of(world, settings), state, rays, hooks));
    CHECK(winds_down == 1);
    CHECK(done == 1);
}

TEST_CASE("a round of very many samples has an end", "[render]") {
    const World world = world_of(four_lamps);
    RenderSettings settings = small(1);
    settings.width = settings.height = 1;
    const std::uint32_t wanted = std::uint32_t{1} << 31;
    settings.samples = static_cast<int>(wanted - 1);
    RenderPlan plan = plan_of(world, settings);
    plan.samples = wanted;
    RenderState state = begin_picture(settings);
    state.rounds = 1;
    state.film.at(0, 0).samples = wanted - 1;
    state.film.at(0, 0).target = wanted;
    LightLedger rays;
    int asked = 0;
    RenderHooks hooks;
    hooks.cancelled = [&] { return ++asked > 1000; };
    CHECK(advance(plan, state, rays, hooks));
    CHECK(state.film.at(0, 0).samples == wanted);
}

TEST_CASE("pixel filters keep even light as it is, and the mean of a picture", "[render][film]") {
    const Image box = render(filmed("pixel_filter box"), of_samples(64)).image;
    for (const std::string name : {"triangle", "mitchell", "blackman_harris"}) {
        INFO(name);
        const Image made = render(filmed("pixel_filter " + name), of_samples(64)).image;
        CHECK(mean_grey(made) == Approx(mean_grey(box)).epsilon(0.005));
        CHECK(made.at(16, 16).x == Approx(0.8).epsilon(1e-9));
        CHECK(made.at(1, 1).x == Approx(box.at(1, 1).x).epsilon(1e-9));
        CHECK(made.pixels != box.pixels);
    }
    // Negative lobes beside the edge: the ground is darker there, and the lamp brighter.
    const Image sharp = render(filmed("pixel_filter mitchell"), of_samples(256)).image;
    double least = 1, greatest = 0;
    for (const Vec3& pixel : sharp.pixels) {
        least = std::min(least, pixel.x);
        greatest = std::max(greatest, pixel.x);
    }
    CHECK(least < 0.295);
    CHECK(greatest > 0.805);
}

TEST_CASE("a bound for noise is for light as the film shows it", "[render][film]") {
    const auto samples = [](const std::string& film) {
        const World world = world_of(R"(
            #version 3.7;
            camera { location <0, 2, -5> look_at 0 film { )" +
                                     film + R"( } }
            sphere { <0, 3, 0>, 0.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 1 } }
            plane { y, -1 pigment { rgb 0.5 } finish { ambient 0 } }
        )");
        RenderSettings settings = of_samples(0);
        settings.width = settings.height = 16;
        settings.noise = 0.002;
        RenderState state = begin_picture(settings);
        LightLedger rays;
        REQUIRE(advance(plan_of(world, settings), state, rays));
        std::uint64_t sum = 0;
        for (const PixelSum& pixel : state.film.pixels()) sum += pixel.samples;
        return sum;
    };
    CHECK(samples("exposure 3") > 2 * samples("exposure 0"));
    CHECK(samples("exposure -4") <= samples("exposure 0"));
}

}  // namespace candelabra
