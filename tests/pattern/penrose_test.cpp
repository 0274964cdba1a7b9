// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/penrose.h"

#include "base/circle.h"
#include "pattern/values.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace candelabra {

namespace {

/// Measurements by POV-Ray 3.7.
struct MeasuredTiling {
    Vec2 place;
    double pentagons, kites, rhombs;
};

const std::vector<MeasuredTiling> measured_tilings = {
    {{-0.952, 1.195}, 0.333334, 0.000000, 0.978571},
    {{8.484, -0.687}, 0.944554, 0.188484, 0.681774},
    {{0.157, 1.748}, 0.392652, 0.156328, 0.141284},
    {{-6.307, 0.238}, 0.288120, 0.835737, 0.373669},
    {{2.598, 5.86}, 0.264592, 0.196519, 0.066189},
    {{-8.118, -3.932}, 0.333334, 0.884611, 0.411257},
    {{-8.187, 6.193}, 0.443135, 0.194149, 0.160345},
    {{3.869, -9.162}, 0.414989, 0.482635, 0.345589},
    {{9.644, 9.295}, 0.316490, 0.162964, 0.240793},
    {{3.078, 2.311}, 0.000000, 0.365229, 0.193182},
    {{-6.85, -9.7}, 0.495590, 0.768798, 0.322187},
    {{0.568, -8.809}, 0.265869, 0.479479, 0.157786},
    {{-6.196, -5.161}, 0.394607, 0.095916, 0.969321},
    {{-9.398, -0.721}, 0.317623, 0.606508, 0.271531},
    {{-11.894, 68.485}, 0.985762, 0.358545, 0.121090},
    {{3.825, 28.058}, 0.333334, 0.382231, 0.404213},
    {{-0.045, 32.49}, 0.810345, 0.089773, 0.323022},
    {{-8.534, -44.367}, 0.711191, 0.441443, 0.180283},
    {{99.531, 99.138}, 0.769113, 0.097670, 0.138044},
    {{2041.293, 1246.858}, 0.333334, 0.805080, 0.022839},
    {{-1108.337, -1622.005}, 0.251130, 0.324078, 0.930665},
    {{-1265.76, -2578.659}, 0.052546, 0.699706, 0.269051},
    {{106515.155, -39840.078}, 0.520012, 0.487394, 0.371689},
    {{138633.449, -45394.587}, 0.396558, 0.822914, 0.000000},
};

/// Returns points that cover the square from -size to size evenly.
std::vector<Vec2> even_points(int count, double size) {
    const auto fraction = [](double value) { return value - std::floor(value); };
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i)
        points.push_back(2 * size * Vec2(fraction(i * 0.7548776662), fraction(i * 0.5698402910)) -
                         Vec2(size));
    return points;
}

constexpr std::array penrose_tilings = {penrose_pentagons, penrose_kites, penrose_rhombs};

/// Returns the fraction of random points whose values are from `low` to `high`.
double share_of_values(double (*tiling)(const Vec2&), double low, double high) {
    std::mt19937 random(5);
    std::uniform_real_distribution<> coordinate(-150, 150);
    constexpr int count = 40000;
    int within = 0;
    for (int i = 0; i < count; ++i) {
        const double x = coordinate(random), y = coordinate(random);
        const double value = tiling({x, y});
        within += value >= low && value <= high ? 1 : 0;
    }
    return double(within) / count;
}

}  // namespace

TEST_CASE("Penrose's tilings have POV-Ray's values", "[pattern]") {
    for (const MeasuredTiling& row : measured_tilings) {
        INFO(row.place.x << ", " << row.place.y);
        CHECK(penrose_pentagons(row.place) == Approx(row.pentagons).margin(2e-6).epsilon(0));
        CHECK(penrose_kites(row.place) == Approx(row.kites).margin(2e-6).epsilon(0));
        CHECK(penrose_rhombs(row.place) == Approx(row.rhombs).margin(2e-6).epsilon(0));
    }
    const std::array sums = {136.7684, 160.5648, 165.1479};
    for (std::size_t i = 0; i < 3; ++i) {
        double sum = 0;
        for (const Vec2& point : even_points(400, 100)) sum += penrose_tilings[i](point);
        INFO("tiling " << 25 + i);
        CHECK(sum == Approx(sums[i]).margin(2e-4).epsilon(0));
    }
}

TEST_CASE("Penrose's tilings are symmetric around the origin", "[pattern]") {
    const Vec2 turn = on_circle(2 * std::numbers::pi / 5);
    for (const auto tiling : penrose_tilings)
        for (const Vec2& p : even_points(300, 40)) {
            INFO(p.x << ", " << p.y);
            const double value = tiling(p);
            CHECK(tiling({p.x, -p.y}) == Approx(value).margin(1e-9));
            CHECK(tiling({p.x * turn.x - p.y * turn.y, p.x * turn.y + p.y * turn.x}) ==
                  Approx(value).margin(1e-9));
        }
}

TEST_CASE("the tiles of Penrose's tilings are in the golden ratio", "[pattern]") {
    using std::numbers::phi;
    // Shares of the area: there are phi times as many large tiles as small ones, and each is phi
    // times as large.
    const double large = phi * phi / (phi * phi + 1);
    CHECK(share_of_values(penrose_kites, 0, 0.5) == Approx(large).margin(0.007));
    CHECK(share_of_values(penrose_rhombs, 0, 0.5) == Approx(large).margin(0.007));
    // Each thick and each thin rhomb has a total angle of 360 degrees, which it shares among the
    // centres of pentagons and of gaps.
    const double pentagon = 5 * 0.25 / std::tan(std::numbers::pi / 5);
    const double side = 1 / std::tan(std::numbers::pi / 5);
    const double rhomb =
        side * side * (phi * std::sin(0.4 * std::numbers::pi) + std::sin(0.2 * std::numbers::pi)) /
        (phi + 1);
    // A thick rhomb has one fifth of the middle of a gap, and a thin one two fifths; the other
    // corners are those of pentagons, and there are as many corners as rhombs.
    const double gaps = (phi * 0.2 + 0.4) / (phi + 1);
    CHECK(share_of_values(penrose_pentagons, 0, 0.5) ==
          Approx((1 - gaps) * pentagon / rhomb).margin(0.007));
}

TEST_CASE("Penrose's tilings are defined everywhere", "[pattern]") {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (const auto tiling : penrose_tilings) {
        for (const double far : {1e6, 1e9, 1e12, 9e12, 1e13, 1e30, 1e308, infinity, none})
            for (const Vec2& p : {Vec2(far, 0.3), Vec2(-0.7, -far), Vec2(far, far)}) {
                INFO(p.x << ", " << p.y);
                const double value = tiling(p);
                CHECK((value >= 0 && value <= 1));
            }
        // Corners and borders of tiles
        for (int x = -20; x <= 20; ++x) {
            const double value = tiling({x * 0.5, 0});
            CHECK((value >= 0 && value <= 1));
        }
        CHECK(tiling({1e30, 0}) == tiling({0, 0}));
    }
}

}  // namespace candelabra
