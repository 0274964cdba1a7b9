// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/media_choices.h"

#include <catch2/catch.hpp>

#include <array>
#include <vector>

namespace candelabra {

namespace {

/// A box of media that glows evenly.
MediaBox even_media(const Vec3& middle) {
    std::array<double, EmissionGrid::count> even;
    even.fill(1);
    return {{middle - 0.5, middle + 0.5}, make_handle<EmissionGrid>(even, 1e-9), Rgb(1), 0};
}

/// Mean of the light that arrives at the origin from above.
double mean_arriving(const MediaChoices& lights, const LightProbe& probe) {
    constexpr int steps = 40;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
            sum += lights.arriving(0, {{Vec3(0), Vec3(0, 1, 0)}, 1e-9},
                                   {(i + 0.5) / steps, (j + 0.5) / steps}, probe);
    return sum / (steps * steps);
}

}  // namespace

TEST_CASE("what shadow rays of a survey find of media is dimmed by what lies before them",
          "[world]") {
    const std::vector<MediaBox> boxes = {even_media(Vec3(0, 5, 0))};
    const MediaChoices lights(boxes);
    CHECK(lights.size() == 1);
    CHECK_FALSE(lights.has_surface(0));
    CHECK_FALSE(lights.falls_off());
    const Receiver point{Vec3(0), Vec3(0, 1, 0)};
    const auto nothing = [](const Ray&, double) -> std::optional<ProbeHit> { return {}; };
    CHECK(mean_arriving(lights, nothing) == Approx(lights.unoccluded(0, point)).epsilon(0.05));
    const auto pane = [](const Ray&, double tolerance) -> std::optional<ProbeHit> {
        if (tolerance < 1) return ProbeHit{1, Vec3(0, -1, 0), 1e-9, {}, 0, 0.25};
        return {};
    };
    CHECK(mean_arriving(lights, pane) == Approx(0.25 * lights.unoccluded(0, point)).epsilon(0.05));
}

TEST_CASE("a box of media is chosen by its bounds, and by its bent normal if it has one",
          "[world]") {
    const std::vector<MediaBox> boxes = {even_media(Vec3(0)), even_media(Vec3(9))};
    CHECK(MediaChoices(boxes).bounds(1).intensity == bounds(boxes[1]).intensity);
    CHECK(MediaChoices(boxes).bounds(1).bent_normal == Vec3(0));
    const std::vector<Vec3> bent = {Vec3(0.1, 0, 0), Vec3(0, 0.2, 0)};
    CHECK(MediaChoices(boxes, bent).bounds(1).bent_normal == bent[1]);
}

}  // namespace candelabra
