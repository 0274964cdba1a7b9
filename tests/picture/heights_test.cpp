// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/heights.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// Returns the heights of a picture file with this content.
std::optional<Heights> heights(const std::string& extension, const std::string& content,
                               double gamma = 0) {
    Diagnostics diagnostics;
    const auto result = read_heights({"a" + extension, content}, gamma, diagnostics);
    CHECK(diagnostics.failed() == !result.has_value());
    return result;
}

}  // namespace

TEST_CASE("pictures are heights from their last row on", "[picture]") {
    const auto grey = heights(".pgm", std::string("P5 2 2 255\n\0\xff\x01\x80", 15));
    REQUIRE(grey);
    CHECK(grey->width == 2);
    CHECK(grey->values == std::vector<std::uint16_t>{257, 32896, 0, 65535});
    const auto colours = heights(".ppm", std::string("P6 2 1 255\n\x01\x02\x03\xff\x00\x07", 17));
    REQUIRE(colours);
    CHECK(colours->values == std::vector<std::uint16_t>{258, 65280});
    const auto squared = heights(".pgm", std::string("P5 1 1 255\n\x80", 12), 2);
    REQUIRE(squared);
    CHECK(squared->values.at(0) == Approx(65535 * 0.252).epsilon(1e-3));
}

TEST_CASE("a potential has its higher bytes on the left and its lower ones on the right",
          "[picture]") {
    const Heights whole{4, 2, {0x0100, 0x0200, 0x0300, 0x0400, 0xff00, 0, 0xff00, 0x0700}};
    const Heights result = of_two_halves(whole);
    CHECK(result.width == 2);
    CHECK(result.height == 2);
    CHECK(result.values == std::vector<std::uint16_t>{0x0103, 0x0204, 0xffff, 0x0007});
}

TEST_CASE("what is no picture has no heights", "[picture]") {
    CHECK_FALSE(heights(".png", "nothing"));
}

}  // namespace candelabra
