// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/blur_rule.h"

#include "support/grey_film.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("pixels behind a lens get samples until their mean is known, or no more", "[render]") {
    RenderSettings settings = tiny_picture();
    settings.antialias = false;
    RenderState state = begin_picture(settings);
    const BlurRule rule{{10, 60, 0.01, 0.9}};
    while (plan_round(state, settings, 10, rule)) take_wanted(state.film);
    CHECK(state.film.at(3, 3).samples == 10);
    const PixelSum& noisy = state.film.at(15, 3);
    CHECK(noisy.samples > 20);
    CHECK(noisy.samples < 60);
    CHECK(noisy.variance_of_mean() < rule.rays.allowed(static_cast<int>(noisy.samples)));
    state = begin_picture(settings);
    while (plan_round(state, settings, 10, BlurRule{{10, 25, 1e-6, 0.9}})) take_wanted(state.film);
    CHECK(state.film.at(15, 3).samples == 25);
}

}  // namespace candelabra
