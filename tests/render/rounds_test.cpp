// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/rounds.h"

#include "support/four_lamps.h"

#include <catch2/catch.hpp>

#include <atomic>

namespace candelabra {

TEST_CASE("a picture begins where one points, and is the same", "[render]") {
    const Shot shot = shot_of(four_lamps);
    RenderSettings settings = small(1);
    settings.width = settings.height = 64;
    settings.samples = 1;
    const RenderPlan plan = plan_of(shot, settings);
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
    CHECK(state.film.image().pixels == render(shot, settings).image.pixels);
}

TEST_CASE("the picture has the same bytes for any number of threads", "[render]") {
    const Shot shot = shot_of(four_lamps);
    const Rendering one = render(shot, small(1));
    for (const int threads : {2, 7}) {
        const Rendering many = render(shot, small(threads));
        CHECK(many.image.pixels == one.image.pixels);
        CHECK(many.rays.shadow == one.rays.shadow);
    }
}

TEST_CASE("a picture that is stopped and continued again and again is the same", "[render]") {
    const Shot shot = shot_of(four_lamps);
    RenderSettings settings = small(2);
    RenderState whole = begin_picture(settings), broken = whole;
    LightLedger rays;
    CHECK(advance(plan_of(shot, settings), whole, rays, {}));
    std::atomic<int> asked = 0;
    RenderHooks hooks;
    int stops = 0, next = 40;
    hooks.cancelled = [&] { return ++asked > next; };
    while (!advance(plan_of(shot, settings), broken, rays, hooks)) {
        asked = 0;
        next = 40 + 61 * (++stops % 5);
        REQUIRE(stops < 1000);
    }
    CHECK(stops > 3);
    CHECK(broken == whole);
}

TEST_CASE("a round winds down once, before its last tile is done", "[render]") {
    const Shot shot = shot_of(four_lamps);
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
    CHECK(advance(plan_of(shot, settings), state, rays, hooks));
    CHECK(winds_down == 1);
    CHECK(done == 1);
}

TEST_CASE("a round of very many samples has an end", "[render]") {
    const Shot shot = shot_of(four_lamps);
    RenderSettings settings = small(1);
    settings.width = settings.height = 1;
    const std::uint32_t wanted = std::uint32_t{1} << 31;
    settings.samples = static_cast<int>(wanted - 1);
    RenderPlan plan = plan_of(shot, settings);
    plan.samples = wanted;
    RenderState state = begin_picture(settings);
    state.rounds = 1;
    state.film.at(0, 0).samples = wanted - 1;
    state.film.at(0, 0).planned = wanted;
    LightLedger rays;
    int asked = 0;
    RenderHooks hooks;
    hooks.cancelled = [&] { return ++asked > 1000; };
    CHECK(advance(plan, state, rays, hooks));
    CHECK(state.film.at(0, 0).samples == wanted);
}

}  // namespace candelabra
