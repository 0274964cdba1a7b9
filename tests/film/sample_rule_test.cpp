// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/sample_rule.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

struct Chosen {
    RenderSettings settings = {};
    Projection camera = {};
    FilmSettings film = {};
    bool random = false, quiet = false;

    SampleRule rule() const { return choose_rule({settings, camera, film, 1, random, quiet}); }
    template <class Rule>
    bool is() const {
        return std::holds_alternative<Rule>(rule());
    }
};

}  // namespace

TEST_CASE("a rule is chosen by the settings, the camera and the noise of light", "[film]") {
    Chosen picture;
    picture.settings.antialias = false;
    CHECK(picture.is<NoiseRule>());
    picture.settings.antialias = true;
    picture.settings.sampling_method = 1;
    CHECK(picture.is<ContrastRule>());
    picture.settings.sampling_method = 2;
    CHECK(picture.is<CornerRule>());
    SECTION("light that is left to chance is sampled by its noise") {
        picture.random = true;
        CHECK(std::get<NoiseRule>(picture.rule()).at_most == 0);
        picture.quiet = true;
        picture.settings.antialias_depth = 3;
        CHECK(std::get<NoiseRule>(picture.rule()).at_most == 10);
    }
    SECTION("a wide filter needs samples everywhere") {
        picture.film.on = true;
        picture.film.pixel_filter = "triangle";
        CHECK(picture.is<NoiseRule>());
    }
    SECTION("a lens counts, unless numbers of samples are requested") {
        picture.camera.lens_radius = 0.1;
        picture.camera.blur = {4, 20, 0.01, 0.9};
        CHECK(std::get<BlurRule>(picture.rule()).rays.most == 20);
        picture.settings.samples = 3;
        CHECK(picture.is<NoiseRule>());
    }
    SECTION("a requested bound of noise counts") {
        picture.settings.noise = 0.01;
        CHECK(picture.is<NoiseRule>());
    }
}

TEST_CASE("the first round sees what it must", "[film]") {
    CHECK(NoiseRule().first({8, 3}) == 8);
    CHECK(NoiseRule().first({2, 3}) == 3);
    CHECK(NoiseRule{10}.first({8, 0}) == 4);
    CHECK(NoiseRule{10}.first({2, 7}) == 7);
    CHECK(BlurRule{{5, 9}}.first({1, 3}) == 5);
    CHECK(BlurRule{{1, 9}}.first({1, 1}) == 2);
    CHECK(contrast_rule({}, 1).first({8, 3}) == 2);
    CHECK(corner_rule({}, 1).first({8, 3}) == 1);
}

}  // namespace candelabra
