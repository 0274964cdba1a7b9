// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/message.h"

#include <catch2/catch.hpp>

#include <cstdint>
#include <limits>
#include <string>

namespace candelabra {

TEST_CASE("parts of several types are joined") {
    const std::string word = "torus";
    CHECK(message() == "");
    CHECK(message("`", word, "` needs ", 2, " numbers") == "`torus` needs 2 numbers");
    CHECK(message(std::string_view("a"), 'b', std::size_t{3}, -4L) == "ab3-4");
    CHECK(message(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
    CHECK(message(std::numeric_limits<std::uint64_t>::max()) == "18446744073709551615");
}

TEST_CASE("floating point numbers are written shortly and exactly") {
    struct Case {
        double number;
        std::string text;
    };
    const double infinity = std::numeric_limits<double>::infinity();
    const Case cases[] = {
        {0, "0"},
        {-0.0, "0"},
        {1, "1"},
        {-2, "-2"},
        {0.25, "0.25"},
        {0.1, "0.1"},
        {100000, "100000"},
        {123456789, "123456789"},
        {1e14, "100000000000000"},
        {1e15, "1e+15"},
        {1e22, "1e+22"},
        {0.0001, "0.0001"},
        {0.00001, "1e-05"},
        {1.5e-7, "1.5e-07"},
        {1.0 / 3, "0.3333333333333333"},
        {infinity, "inf"},
        {-infinity, "-inf"},
        {std::nan(""), "nan"},
        {std::numeric_limits<double>::max(), "1.7976931348623157e+308"},
        {-std::numeric_limits<double>::denorm_min(), "-5e-324"},
    };
    for (const Case& each : cases) CHECK(message(each.number) == each.text);
    CHECK(message(0.1f) == "0.1");
}

}  // namespace candelabra
