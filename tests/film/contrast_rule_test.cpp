// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/contrast_rule.h"

#include "support/edges.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns a pixel of the middle row.
double seen(const std::string& scene, const RenderSettings& settings, int column) {
    return render(shot_of(scene), settings).image.at(column, 1).r;
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
    // Values brighter than white are not clipped.
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
        // A difference in grey counts in all three channels.
        CHECK(seen(edge(1.6, 0.2, 0.2 + each.least - 3e-4), settings, 1) == Approx(0.2));
        CHECK(seen(edge(1.6, 0.2, 0.2 + each.least + 3e-4), settings, 1) > 0.2 + 0.25 * each.least);
    }
}

TEST_CASE("smooth parts of a picture take one ray a pixel", "[render]") {
    // Seven more lie above the picture and to its left (four and three), as in POV-Ray.
    const Rendering picture = render(shot_of(edge(1.6, 0, 1)), rows(3));
    CHECK(picture.rays.camera == 12 + 7 + 9 * 6);
}

TEST_CASE("a pixel is compared with what the one before it has become", "[render]") {
    // A row of pixels: values of their first rays and of all their rays.
    struct Row {
        std::vector<double> first, all;
        std::string expected;  ///< 1: all rays were requested
    };
    const Row rows_of[] = {
        {{0, 0, 0, 0}, {1, 1, 1, 1}, "0000"},
        {{0, 1, 1, 1}, {0, 1, 1, 1}, "1100"},
        {{0, 1, 1, 1}, {0.5, 0.5, 1, 1}, "1110"},
        {{0, 0, 0, 1}, {0.5, 0.5, 0.5, 0.5}, "0011"},
    };
    for (const auto& [first, all, expected] : rows_of) {
        CAPTURE(expected);
        std::string got = "0000";
        const auto value = [](double v) { return DisplayValue{Rgb(v), 0}; };
        const auto first_of = [&](int x, int) {
            return value(x < 10 ? first[0] : first[static_cast<std::size_t>(x) - 10]);
        };
        const auto all_of = [&](int x, int y) -> std::optional<DisplayValue> {
            CHECK(y == 5);
            const auto i = static_cast<std::size_t>(x) - 10;
            got[i] = '1';
            return value(all[i]);
        };
        // The row above equals the first rays, so it causes no refinement.
        CHECK(refine_block({0.3, 1, 1}, {10, 5, 14, 6}, {first_of, all_of}));
        CHECK(got == expected);
        const auto stop = [](int, int) -> std::optional<DisplayValue> { return {}; };
        CHECK(refine_block({0.3, 1, 1}, {10, 5, 14, 6}, {first_of, stop}) == (expected == "0000"));
    }
}

TEST_CASE("rays are moved within the square that is theirs", "[render]") {
    RenderSettings settings = rows(3);
    settings.jitter = true;
    const ContrastRule rule = contrast_rule(settings, 1);
    CHECK(rule.all_samples() == 10);
    CHECK(rule.place(Key()) == Vec2(0.5));
    bool moved = false;
    for (std::uint32_t i = 1; i < 10; ++i) {
        Key key;
        key.sample = i;
        const Vec2 place = rule.place(key).value(), cell = glm::floor(3.0 * place);
        CHECK(cell == Vec2((i - 1) % 3, (i - 1) / 3));
        moved |= place != (cell + 0.5) / 3.0;
    }
    CHECK(moved);
}

TEST_CASE("where light is left to chance, rays follow the noise", "[render]") {
    RenderSettings settings = rows(3);
    const std::string scene =
        edge(1.6, 0, 1) + "sphere { <9, 9, -9>, 1 pigment { rgb 1 } finish { emission 1 } }";
    CHECK(render(shot_of(scene), settings).rays.camera >= 8 * 12);
}

}  // namespace candelabra
