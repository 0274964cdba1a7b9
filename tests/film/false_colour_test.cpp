// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/false_colour.h"

#include <catch2/catch.hpp>

#include <limits>

namespace candelabra {

namespace {

/// Values that rise from 0 to `most` from left to right.
Image rising(double most, int width = 200) {
    Image values(width, 60);
    for (int y = 0; y < values.height; ++y)
        for (int x = 0; x < width; ++x) values.at(x, y) = Rgb(most * x / (width - 1));
    return values;
}

double lightness(const Rgb& c) { return c.r * 0.2126 + c.g * 0.7152 + c.b * 0.0722; }

}  // namespace

TEST_CASE("scales end at 1, 2 and 5 times powers of ten", "[film]") {
    CHECK(round_upward(1) == 1);
    CHECK(round_upward(1.01) == 2);
    CHECK(round_upward(300) == 500);
    CHECK(round_upward(5.5) == 10);
    CHECK(round_upward(0.03) == Approx(0.05));
    CHECK(fitting_scale(rising(900)) == 1000);
    CHECK(fitting_scale(Image(10, 10)) == 1);
    Image one = rising(0.4);
    one.at(3, 3) = Rgb(1e9);
    one.at(4, 4) = Rgb(std::numeric_limits<double>::infinity());
    CHECK(fitting_scale(one) == Approx(0.5));
}

TEST_CASE("greater values are lighter, and those beyond the scale have a colour of their own",
          "[film]") {
    const Image shown = false_coloured(rising(100), {.most = 80, .unit = "lx"});
    CHECK(shown.width == 200);
    CHECK(shown.height > 60);
    for (int x = 1; x < 155; ++x) CHECK(lightness(shown.at(x, 5)) >= lightness(shown.at(x - 1, 5)));
    CHECK(shown.at(199, 5) == shown.at(165, 5));
    CHECK(shown.at(199, 5).r > 2 * shown.at(199, 5).g);
    Image none = rising(1);
    none.at(7, 7) = Rgb(std::numeric_limits<double>::infinity());
    CHECK(false_coloured(none, {}).at(7, 7).r == Approx(false_coloured(none, {}).at(7, 7).b));
}

TEST_CASE("isolines stand at the marks of the scale", "[film]") {
    const FalseColours plain{.most = 100, .unit = "lx"};
    FalseColours lined = plain;
    lined.isolines = true;
    const Image without = false_coloured(rising(100), plain),
                with = false_coloured(rising(100), lined);
    // 20, 40, 60, 80 and 100, in a row without a number.
    std::vector<int> lines;
    const auto differs = [&](int x) { return with.at(x, 5) != without.at(x, 5); };
    for (int x = 1; x < 200; ++x)
        if (differs(x) && !differs(x - 1)) lines.push_back(x);
    REQUIRE(lines.size() == 5);
    for (int i = 0; i < 5; ++i)
        CHECK(lines[static_cast<std::size_t>(i)] == Approx(39.8 * (i + 1)).margin(2));
    // One pixel of noise makes no line.
    Image spot = rising(0);
    spot.at(50, 30) = Rgb(90);
    CHECK(false_coloured(spot, lined).at(49, 30) == false_coloured(spot, plain).at(49, 30));
}

}  // namespace candelabra
