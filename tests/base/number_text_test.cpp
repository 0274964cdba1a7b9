// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/number_text.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace candelabra {

namespace {

struct NumberInText {
    std::string_view text;
    std::size_t length;  ///< of the number
    double value;
    std::errc problem = {};
};

}  // namespace

TEST_CASE("numbers are read as far as they go, to the nearest double", "[base]") {
    constexpr auto none = std::errc::invalid_argument, range = std::errc::result_out_of_range;
    const NumberInText table[] = {{"1", 1, 1},
                                  {"-1.5;", 4, -1.5},
                                  {".5", 2, 0.5},
                                  {"5.", 2, 5},
                                  {"1e3x", 3, 1000},
                                  {"1e", 1, 1},
                                  {"1e+", 1, 1},
                                  {"1.5e-1.5", 6, 0.15},
                                  {"0x10", 1, 0},
                                  {"0.1", 3, 0.1},
                                  {"9007199254740993", 16, 9007199254740992.0},
                                  {"2.2250738585072011e-308", 23, 2.2250738585072011e-308},
                                  {"4.9e-324", 8, 4.9e-324},
                                  {"0e99999", 7, 0},
                                  {"-0", 2, -0.0},
                                  {"1e400", 5, 0, range},
                                  {"1e-400", 6, 0, range},
                                  {"", 0, 0, none},
                                  {"-", 0, 0, none},
                                  {".", 0, 0, none},
                                  {"+1", 0, 0, none},
                                  {" 1", 0, 0, none},
                                  {"e5", 0, 0, none}};
    for (const NumberInText& row : table) {
        INFO(row.text);
        double value = 77;
        const auto [end, problem] =
            number_from(row.text.data(), row.text.data() + row.text.size(), value);
        CHECK(static_cast<std::size_t>(end - row.text.data()) == row.length);
        CHECK(problem == row.problem);
        CHECK(value == (row.problem == std::errc() ? row.value : 77));
        CHECK((problem != std::errc() || std::signbit(value) == std::signbit(row.value)));
    }
}

TEST_CASE("numbers in base sixteen, and words for numbers", "[base]") {
    double value = 0;
    const std::string_view sixteen = "fe.8g", word = "-INF", other = "nan";
    CHECK(number_from(sixteen.data(), sixteen.data() + 5, value, std::chars_format::hex).ptr ==
          sixteen.data() + 4);
    CHECK(value == 254.5);
    CHECK(number_from(word.data(), word.data() + 4, value).ptr == word.data() + 4);
    CHECK(value == -HUGE_VAL);
    CHECK(number_from(other.data(), other.data() + 3, value).ptr == other.data() + 3);
    CHECK(std::isnan(value));
}

TEST_CASE("a float is rounded once", "[base]") {
    // Rounded to a double first, this would become 1.
    const std::string_view above = "1.00000005960464477540";
    float value = 0;
    CHECK(number_from(above.data(), above.data() + above.size(), value).ec == std::errc());
    CHECK(value == 1.00000011920928955078125F);
}

}  // namespace candelabra
