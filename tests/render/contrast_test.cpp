// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/contrast.h"

#include "support/edges.h"

#include <catch2/catch.hpp>

namespace {

/// In the middle row.
double seen(const std::string& scene, const RenderSettings& settings, int column) {
    return render(world_of(scene), settings).image.at(column, 1).x;
}

}  // namespace

TEST_CASE("pixels at an edge are as in POV-Ray", "[render]") {
    struct Edge {
        double place;
        int depth;
        double value;
    };
    for (const Edge& each : {Edge{1.6, 2, 0.4}, Edge{1.6, 3, 0.3}, Edge{1.2, 3, 0.7}}) {
        CAPTURE(each.place, each.depth);
        const std::string scene = edge(each.place, 0, 1);
        CHECK(seen(scene, rows(each.depth), 1) == Approx(each.value));
        CHECK(seen(scene, rows(each.depth), 0) == 0);
        CHECK(seen(scene, rows(each.depth), 3) == 1);
    }
    // What is brighter than white counts in full.
    CHECK(seen(edge(1.8, 0, 2), rows(3), 1) == Approx(0.6));
}

TEST_CASE("a pixel gets more rays from a difference on, in values of a gamma", "[render]") {
    struct Step {
        double gamma, least;
    };
    for (const Step& each : {Step{2.5, 0.1093}, Step{2.2, 0.1030}, Step{1, 0.1}}) {
        CAPTURE(each.gamma);
        RenderSettings settings = rows(3);
        settings.antialias_gamma = each.gamma;
        // Grey counts three times, once for each channel.
        CHECK(seen(edge(1.6, 0.2, 0.2 + each.least - 3e-4), settings, 1) == Approx(0.2));
        CHECK(seen(edge(1.6, 0.2, 0.2 + each.least + 3e-4), settings, 1) > 0.2 + 0.25 * each.least);
    }
}

TEST_CASE("smooth parts of a picture take one ray a pixel", "[render]") {
    const Rendering picture = render(world_of(edge(1.6, 0, 1)), rows(3));
    CHECK(picture.rays.camera == 12 + 9 * 6);
}

TEST_CASE("rays are moved within the square that is theirs", "[render]") {
    RenderSettings settings = rows(3);
    settings.jitter = true;
    const ContrastRule rule = contrast_rule(settings, 1);
    CHECK(all_samples(rule) == 10);
    CHECK(place_in_pixel(rule, Key()) == Vec2(0.5));
    bool moved = false;
    for (std::uint32_t i = 1; i < 10; ++i) {
        Key key;
        key.sample = i;
        const Vec2 place = place_in_pixel(rule, key), cell = glm::floor(3.0 * place);
        CHECK(cell == Vec2((i - 1) % 3, (i - 1) / 3));
        moved |= place != (cell + 0.5) / 3.0;
    }
    CHECK(moved);
}

TEST_CASE("where light is left to chance, rays follow the noise", "[render]") {
    RenderSettings settings = rows(3);
    const std::string scene =
        edge(1.6, 0, 1) + "sphere { <9, 9, -9>, 1 pigment { rgb 1 } finish { emission 1 } }";
    CHECK(render(world_of(scene), settings).rays.camera >= 8 * 12);
}
