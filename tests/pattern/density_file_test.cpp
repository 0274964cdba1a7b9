// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/density_file.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using namespace std::string_view_literals;

/// 2 x 1 x 2 values of one byte: 0, 51, 102, 255.
constexpr std::string_view small = "\0\2\0\1\0\2\x00\x33\x66\xff"sv;

DensityFile file_of(std::string_view content, int interpolate = 0) {
    const auto grid = read_density_grid(content);
    REQUIRE(grid);
    return {"", interpolate, make_handle<DensityGrid>(*grid)};
}

}  // namespace

TEST_CASE("a density file has one value for each box of the unit cube", "[pattern]") {
    const DensityFile file = file_of(small);
    CHECK(evaluate(file, {0.2, 0.5, 0.2}) == 0);
    CHECK(evaluate(file, {0.7, 0.5, 0.2}) == Approx(0.2));
    CHECK(evaluate(file, {0.2, 0.5, 0.7}) == Approx(0.4));
    CHECK(evaluate(file, {0.7, 0.5, 0.7}) == Approx(1));
    for (const Vec3& outside : {Vec3(1, 0.5, 0.5), Vec3(0.5, -0.001, 0.5), Vec3(0.5, 0.5, 2)})
        CHECK(evaluate(file, outside) == 0);
    CHECK(evaluate(DensityFile{}, {0.5, 0.5, 0.5}) == 0);
}

TEST_CASE("values of two and four bytes have the high byte first", "[pattern]") {
    CHECK(evaluate(file_of("\0\1\0\1\0\1\x80\x00"sv), Vec3(0.5)) == Approx(32768.0 / 65535));
    CHECK(evaluate(file_of("\0\1\0\1\0\1\x40\x00\x00\x00"sv), Vec3(0.5)) ==
          Approx(1073741824.0 / 4294967295.0));
}

TEST_CASE("values are at the lower corners, and wrap round", "[pattern]") {
    const DensityFile linear = file_of(small, 1), cubic = file_of(small, 2);
    CHECK(evaluate(linear, {0, 0, 0}) == 0);
    CHECK(evaluate(linear, {0.25, 0, 0}) == Approx(0.1));
    CHECK(evaluate(linear, {0.75, 0, 0}) == Approx(0.1));
    CHECK(evaluate(linear, {0.25, 0.9, 0.25}) == Approx((0 + 0.2 + 0.4 + 1) / 4));
    for (const double x : {0.0, 0.5})
        for (const double z : {0.0, 0.5})
            CHECK(evaluate(cubic, {x, 0, z}) == Approx(evaluate(linear, {x, 0, z})));
    CHECK(evaluate(cubic, {0.25, 0, 0}) == Approx(0.1));
    CHECK(evaluate(file_of(small, 11), {0.25, 0, 0}) == Approx(0.1));
}

TEST_CASE("what is no df3 file is told apart", "[pattern]") {
    for (const std::string_view wrong : {""sv, "\0\1\0\1"sv, "\0\1\0\1\0\1"sv, "\0\0\0\1\0\1\1"sv,
                                         "\0\1\0\1\0\1\1\2\3"sv, "\0\2\0\1\0\2\x00\x33\x66"sv})
        CHECK_FALSE(read_density_grid(wrong));
}

}  // namespace candelabra
