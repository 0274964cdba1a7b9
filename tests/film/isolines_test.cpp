// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/isolines.h"

#include "base/random.h"
#include "film/plate_text.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace candelabra {

namespace {

constexpr int wide = 160, high = 120;
const Vec2 middle(80.3, 52.7);

/// Values that fall with the distance from the middle, 1 for a pixel, with noise of that deviation.
Image falling_cone(double deviation) {
    Image values(wide, high);
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) {
            RandomStream random({static_cast<std::uint64_t>(y * wide + x)}, Purpose::pixel_x);
            double noise = -6;  // the sum of twelve uniform numbers is nearly normal
            for (int i = 0; i < 12; ++i) noise += random.next();
            const double away = glm::length(Vec2(x + 0.5, y + 0.5) - middle);
            values.at(x, y) = Rgb(100 - away + deviation * noise);
        }
    return values;
}

/// Root of the mean square of how far the points of the lines are from their circles.
double raggedness(const std::vector<Isoline>& lines) {
    double squares = 0, count = 0;
    for (const Isoline& line : lines)
        for (const Vec2& point : line.points) {
            const double off = glm::length(point - middle) - (100 - line.value);
            squares += off * off;
            ++count;
        }
    return std::sqrt(squares / count);
}

}  // namespace

TEST_CASE("isolines of a cone are circles between the pixels", "[film]") {
    const std::vector<Isoline> lines = isolines_of(calmed(falling_cone(0)), 40, 100, 10);
    REQUIRE(lines.size() == 2);  // 80 is closed; 40 is cut by the upper edge
    CHECK(raggedness(lines) < 0.1);
    for (const Isoline& line : lines)
        if (line.value == 80) {
            CHECK(line.points.front() == line.points.back());
            CHECK(line.length == Approx(2 * 3.14159 * 20).epsilon(0.01));
        }
    CHECK(isolines_of(calmed(falling_cone(0)), 40, 100, 1e4).empty());
}

TEST_CASE("noise makes isolines hardly ragged", "[film]") {
    // Without calming, noise of four pixels' worth breaks lines into hundreds.
    const Image noisy = falling_cone(4);
    NumberField raw{wide, high, {}};
    for (const Rgb& each : noisy.pixels) raw.numbers.push_back(each.r);
    CHECK(isolines_of(raw, 40, 100, 0).size() > 100);
    const std::vector<Isoline> lines = isolines_of(calmed(noisy), 40, 100, 28);
    CHECK(lines.size() == 2);
    CHECK(raggedness(lines) < 1.2);
}

TEST_CASE("steps of objects remain, and no line follows them", "[film]") {
    Image values(wide, high);
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) values.at(x, y) = Rgb(x < 80 ? 5 : 95);
    const NumberField field = calmed(values);
    CHECK(field.at(79, 50) == 5);
    CHECK(field.at(80, 50) == 95);
    CHECK(isolines_of(field, 20, 100, 0).empty());
    values.at(3, 3) = Rgb(std::numeric_limits<double>::infinity());
    values.at(4, 3) = Rgb(std::numeric_limits<double>::quiet_NaN());
    CHECK(calmed(values).at(3, 3) == 5);
    Image one(1, 1);
    one.at(0, 0) = Rgb(std::numeric_limits<double>::quiet_NaN());
    CHECK(calmed(one).at(0, 0) == 0);
    CHECK(isolines_of(calmed(one), 1, 5, 0).empty());
    CHECK(isolines_of(calmed(Image()), 1, 5, 0).empty());
}

TEST_CASE("a saddle has two lines that do not meet", "[film]") {
    Image values(40, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) values.at(x, y) = Rgb(1 + 0.01 * (x - 19.6) * (y - 20.3));
    const std::vector<Isoline> lines = isolines_of(calmed(values), 1, 1, 5);
    CHECK(lines.size() == 2);
}

TEST_CASE("long lines have their number in a gap, and nothing is drawn below", "[film]") {
    const std::vector<Isoline> lines = isolines_of(calmed(falling_cone(0)), 40, 80, 10);
    Image picture(wide, high);
    const IsolineLook look{1, [](double) { return Rgb(1); },
                           [](double value) { return std::to_string(static_cast<int>(value)); }};
    draw_isolines(lines, look, 100, picture);
    double drawn = 0, below = 0;
    for (int y = 0; y < high; ++y)
        for (int x = 0; x < wide; ++x) (y < 100 ? drawn : below) += picture.at(x, y).r;
    CHECK(drawn > 200);
    CHECK(below == 0);
    Image without(wide, high);
    const IsolineLook silent{1, look.colour, [](double) { return std::string(); }};
    draw_isolines(lines, silent, 100, without);
    int differing = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        differing += picture.pixels[i] != without.pixels[i] ? 1 : 0;
    CHECK(differing > 20);
}

}  // namespace candelabra
