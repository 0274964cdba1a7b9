// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/corner_rule.h"

#include "support/edges.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

RenderSettings by_corners(int depth) {
    RenderSettings settings = rows(depth);
    settings.sampling_method = 2;
    return settings;
}

}  // namespace

TEST_CASE("corners and quarters at an edge are as in POV-Ray", "[render]") {
    const double expected[] = {0.5, 0.25, 0.375, 0.4375};
    // POV-Ray's numbers of rays: corners, and those inside the three pixels at the edge.
    const std::uint64_t rays[] = {20, 35, 62, 113};
    for (int depth = 1; depth <= 4; ++depth) {
        CAPTURE(depth);
        const Rendering picture = render(shot_of(edge(1.6, 0, 1)), by_corners(depth));
        const std::size_t i = static_cast<std::size_t>(depth) - 1;
        CHECK(picture.image.at(0, 1).r == 0);
        CHECK(picture.image.at(1, 1).r == Approx(expected[i]));
        CHECK(picture.image.at(2, 1).r == 1);
        CHECK(picture.rays.camera == rays[i]);
    }
}

TEST_CASE("what is clear is compared where a picture has an alpha channel", "[render]") {
    const Shot shot = shot_of(R"(
        #version 3.7;
        camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 direction z }
        box { <-9, -9, 0>, <-.4, 9, 1> pigment { rgb 0 } finish { ambient 0 diffuse 0 } })");
    CHECK(render(shot, by_corners(3)).rays.camera == 20);
    RenderHooks hooks;
    hooks.aovs.alpha = true;
    RenderState state = begin_picture(by_corners(3), hooks.aovs.count(*shot.world));
    LightLedger rays;
    CHECK(advance(plan_of(shot, by_corners(3)), state, rays, hooks));
    CHECK(rays.camera == 62);
    const Film& film = state.film;
    CHECK(film.extra(film.index(1, 1))[0].value() == Approx(0.375));
    CHECK(film.at(1, 1).samples == 1);
}

TEST_CASE("rays inside of a pixel are moved, its corners are not", "[render]") {
    RenderSettings settings = by_corners(3);
    settings.jitter = true;
    const CornerRule rule = corner_rule(settings, 1);
    const int places = static_cast<int>(rule.quarters_across()) + 1;
    REQUIRE(places == 5);
    for (int i = 0; i < places * places; ++i) {
        Key key;
        key.sample = static_cast<std::uint32_t>(i);
        const Vec2 row = Vec2(i % places, i / places) / 4.0, moved = rule.place(key).value() - row;
        const bool corner = i == 0 || i == 4 || i == 20 || i == 24;
        CHECK((moved == Vec2(0)) == corner);
        CHECK(std::max(std::abs(moved.x), std::abs(moved.y)) <= 0.5 / 9);
    }
}

TEST_CASE("tiles have the corners of the whole picture", "[render]") {
    // Two tiles whose common edge is in a gradient.
    RenderSettings settings = by_corners(3);
    settings.width = 64;
    settings.height = 4;
    settings.jitter = true;
    settings.antialias_threshold = 0.01;
    const Shot shot = shot_of(R"(
        #version 3.7;
        global_settings { assumed_gamma 1 }
        camera { orthographic location <0, 0, -5> right 16*x up y look_at 0 direction z }
        plane { z, 0 pigment { wood scale 4 } finish { ambient 1 diffuse 0 } })");
    const Image whole = render(shot, settings).image;
    for (int threads : {1, 3}) {
        settings.threads = threads;
        CHECK(render(shot, settings).image.pixels == whole.pixels);
    }
    Region right{32, 0, 64, 4};
    int most = 0;
    CornerCells cells(corner_rule(settings, 1), right);
    const PixelSample sight = cells.pixel(40, 2, [&](int x, int, std::uint32_t) {
        most = std::max(most, x);
        return PixelSample{Rgb(x % 2), 0, {}, 1};
    });
    CHECK(most == 41);
    CHECK(sight.colour.r == Approx(1.0 / 32));
    CHECK(sight.shadow_rays == 15);
}

}  // namespace candelabra
