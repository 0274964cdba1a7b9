// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/volume.h"

#include "support/lights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Twice as bright in one half as in the other, which is not dark.
double brightness_at(const Vec3& place) { return place.x < 0 ? 2 : 1; }

MediaBox two_halves(const Vec3& size) {
    std::array<double, EmissionGrid::count> cells{};
    for (std::size_t i = 0; i < cells.size(); ++i)
        cells[i] = i % EmissionGrid::side < EmissionGrid::side / 2 ? 2 : 1;
    return {{-0.5 * size, 0.5 * size}, make_handle<EmissionGrid>(cells, 1e-3), Rgb(7), 0};
}

/// Irradiance (from all directions, if the receiver is in the air) estimated by the luminaire's
/// points.
double sampled(const MediaBox& e, const Receiver& point, int count, Draw& draw) {
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const auto s = sample(e, point.position, {draw.between(0, 1), draw.between(0, 1)});
        if (!s) continue;
        CHECK(length(point.position + s->distance * s->direction - s->position) < 1e-9);
        sum += std::fmax(point.cosine(s->direction), 0) * brightness_at(s->position) / s->density;
    }
    return sum / count;
}

/// The same by a fine grid of directions, with the integral along each.
double by_directions(const MediaBox& e, const Receiver& point) {
    constexpr int rings = 400, sectors = 400, steps = 60;
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double height = 1 - 2 * (i + 0.5) / rings,
                         across = std::sqrt(1 - height * height),
                         angle = 2 * pi * (j + 0.5) / sectors;
            const Vec3 direction(across * std::cos(angle), across * std::sin(angle), height);
            double enter = 0, leave = INFINITY;
            for (int axis = 0; axis < 3; ++axis) {
                const double a = (e.box.low[axis] - point.position[axis]) / direction[axis],
                             b = (e.box.high[axis] - point.position[axis]) / direction[axis];
                enter = std::fmax(enter, std::fmin(a, b));
                leave = std::fmin(leave, std::fmax(a, b));
            }
            if (!(leave > enter)) continue;
            double along = 0;
            for (int k = 0; k < steps; ++k)
                along += brightness_at(point.position +
                                       (enter + (leave - enter) * (k + 0.5) / steps) * direction);
            sum += std::fmax(point.cosine(direction), 0) * along * (leave - enter) / steps;
        }
    return 4 * pi * sum / (rings * sectors);
}

}  // namespace

TEST_CASE("points of a volume give its light from near, far and within", "[luminaire]") {
    Draw draw(7);
    const MediaBox e = two_halves({2, 1, 0.5});
    const std::vector<Receiver> points = {
        {Vec3(0, 9, 1), -unit(Vec3(0, 9, 1)), Horizon::one_side},
        {Vec3(0.3, 0.9, 0.1), Vec3(0, -1, 0), Horizon::one_side},
        {Vec3(-1.2, 0.2, 0.2), unit(Vec3(1, 1, 0)), Horizon::both_sides},
        {Vec3(0.2, 0.1, 0.1), unit(Vec3(1, 2, 3)), Horizon::one_side},
        {Vec3(0.2, 0.1, 0.1), Vec3(0), Horizon::none},
        {Vec3(0.5, 0.5, 0.25), Vec3(0, 1, 0), Horizon::both_sides}};
    for (const Receiver& point : points) {
        CAPTURE(point.position.x, point.position.y, point.normal.y);
        const double expected = by_directions(e, point);
        CHECK(sampled(e, point, 200000, draw) == Approx(expected).epsilon(0.01));
        // The estimate for choosing luminaires is no worse than a rough guess.
        const double guessed = unoccluded(e, point);
        CHECK(guessed > expected / 8);
        CHECK(guessed < expected * 8);
    }
}

TEST_CASE("near a volume no point gives much more than others", "[luminaire]") {
    Draw draw(8);
    const MediaBox e = two_halves(Vec3(1));
    for (int i = 0; i < 100000; ++i) {
        const Vec3 from = draw.point(0.6);
        const auto s = sample(e, from, {draw.between(0, 1), draw.between(0, 1)});
        // Twice the longest line through the volume, over the density of directions.
        if (s) CHECK(1 / s->density <= 2 * std::sqrt(3.0) * 4 * pi * (1 + 1e-9));
    }
}

TEST_CASE("rays leave a volume with all of its power", "[luminaire]") {
    Draw draw(9);
    const MediaBox e = two_halves({2, 1, 0.5});
    double power = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const EmittedRay ray = emit(e, {{draw.between(0, 1), draw.between(0, 1)},
                                        {draw.between(0, 1), draw.between(0, 1)},
                                        0});
        CHECK(contains(e.box, ray.ray.origin));
        CHECK(dot(ray.normal, ray.ray.direction) == Approx(1));
        power += brightness_at(ray.ray.origin) / ray.density / count;
    }
    CHECK(power == Approx(4 * pi * 1.5).epsilon(0.01));
}

TEST_CASE("cells are drawn by their brightness, and none is left out", "[luminaire]") {
    std::array<double, EmissionGrid::count> cells{};
    cells[5] = 3;
    cells[60] = 1;
    const EmissionGrid grid(cells, 0.01);
    CHECK(grid.mean() == Approx(4.0 / 64));
    CHECK(EmissionGrid({}, 0.01).mean() == 0.01);
    std::array<int, EmissionGrid::count> drawn{};
    constexpr int count = 64000;
    for (int i = 0; i < count; ++i) {
        double u = (i + 0.5) / count;
        const std::size_t cell = grid.draw(u);
        CHECK(u >= 0);
        CHECK(u < 1);
        ++drawn[cell];
    }
    double all = 0;
    for (std::size_t cell = 0; cell < drawn.size(); ++cell) {
        CHECK(drawn[cell] == Approx(count * grid.chance(cell)).margin(2));
        CHECK(drawn[cell] > 0);
        all += grid.chance(cell);
    }
    CHECK(all == Approx(1));
    CHECK(grid.chance(5) == Approx(0.25 / 64 + 0.75 * 0.75));
}

TEST_CASE("a volume has the bounds of its box, and its light is its mean's", "[luminaire]") {
    const MediaBox e = two_halves({2, 1, 0.5});
    const LightBounds b = bounds(e);
    CHECK(b.box.low == Vec3(-1, -0.5, -0.25));
    CHECK(b.centre == Vec3(0));
    CHECK(b.intensity == Approx(1.5));
    CHECK(b.luminance == Approx(7));
    CHECK(emitted_about(e, {-0.9, 0, 0}) == 2);
    CHECK(emitted_about(e, {0.9, 0, 0}) == 1);
}

}  // namespace candelabra
