// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/schedule.h"

#include "support/grey_film.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("an even picture has one round, and another when more is asked for", "[render]") {
    RenderSettings settings = tiny_picture();
    settings.samples = 4;
    RenderState state = begin_picture(settings);
    REQUIRE(plan_round(state, settings, 4));
    CHECK(wanted_samples(state.film).missing == 4u * 36 * 34);
    take_wanted(state.film);
    CHECK_FALSE(plan_round(state, settings, 4));
    REQUIRE(plan_round(state, settings, 7));
    CHECK(wanted_samples(state.film).missing == 3u * 36 * 34);
}

TEST_CASE("the adaptive scheme has two rounds, the second where it is noisy", "[render]") {
    const RenderSettings settings = tiny_picture();
    RenderState state = begin_picture(settings);
    REQUIRE(plan_round(state, settings, 8));
    take_wanted(state.film);
    REQUIRE(plan_round(state, settings, 8));
    CHECK(state.film.at(3, 3).planned == 8);
    CHECK(state.film.at(15, 3).planned == 64);
    take_wanted(state.film);
    CHECK_FALSE(plan_round(state, settings, 8));
}

TEST_CASE("rounds go on until the noise is low enough or the samples are used up", "[render]") {
    RenderSettings settings = tiny_picture();
    settings.noise = 0.05;
    RenderState state = begin_picture(settings);
    int rounds = 0;
    for (; plan_round(state, settings, 16); ++rounds) take_wanted(state.film);
    CHECK(rounds > 3);
    const PixelSum& noisy = state.film.at(15, 9);
    CHECK(noisy.deviation() / std::sqrt(noisy.samples) < 0.0501);
    CHECK(state.film.at(3, 9).samples == 16);
    settings.samples = 100;
    state = begin_picture(settings);
    while (plan_round(state, settings, 16)) take_wanted(state.film);
    CHECK(state.film.at(15, 9).samples == 100);
}

TEST_CASE("a share has its own pixels, and in the adaptive scheme their neighbours", "[render]") {
    RenderSettings settings = tiny_picture();
    RenderState state = begin_picture(settings);
    state.shard.first_tile = 1;
    state.shard.tile_step = 4;
    CHECK(state.shard.owns(32, 0));
    CHECK_FALSE(state.shard.owns(31, 0));
    REQUIRE(plan_round(state, settings, 8));
    CHECK(state.film.at(33, 31).planned == 8);
    CHECK(state.film.at(31, 31).planned == 8);
    CHECK(state.film.at(31, 32).planned == 8);
    CHECK(state.film.at(30, 31).planned == 0);
    settings.samples = 3;
    REQUIRE(plan_round(state, settings, 3));
    CHECK(state.film.at(31, 31).planned == 0);
}

TEST_CASE("where tiles find out what pixels need there is one round, of the share", "[render]") {
    const RenderSettings settings = tiny_picture();
    for (const SampleRule& rule :
         {SampleRule(contrast_rule(settings, 1)), SampleRule(corner_rule(settings, 1))}) {
        CHECK(decided_by(settings, rule) == DecidedBy::tile);
        CHECK_FALSE(is_even(settings, rule));
        RenderState state = begin_picture(settings);
        state.shard.first_tile = 1;
        state.shard.tile_step = 4;
        REQUIRE(plan_round(state, settings, 1, rule));
        CHECK(state.film.at(32, 3).planned == 1);
        CHECK(state.film.at(31, 3).planned == 0);
        take_wanted(state.film);
        CHECK_FALSE(plan_round(state, settings, 1, rule));
    }
}

TEST_CASE("no more samples are planned than the rules can want", "[render]") {
    RenderSettings settings = tiny_picture();
    settings.samples = 4;
    CHECK(max_wanted(settings, 4) == 4);
    settings.samples = 0;
    settings.noise = 0.1;
    CHECK(max_wanted(settings, 4) == 65536);
    settings.samples = 9;
    CHECK(max_wanted(settings, 4) == 9);
    BlurRule blur;
    blur.rays.most = 50;
    CHECK(max_wanted(settings, 4, blur) == 50);

    settings.noise = 1e-9;
    settings.samples = 70;
    RenderState state = begin_picture(settings);
    while (plan_round(state, settings, 8)) {
        CHECK(wanted_samples(state.film).most <= max_wanted(settings, 8));
        take_wanted(state.film);
    }
}

}  // namespace candelabra
