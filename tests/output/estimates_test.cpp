// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/estimates.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

namespace candelabra {

TEST_CASE("estimates have the digits that their errors leave", "[output]") {
    CHECK(rounded(1.0 / 3) == 0.333333);
    CHECK(cell(1234567.8) == "1234570");
    CHECK(shown({12.3456, 0.12345}) == "12.35 +- 0.12");
    CHECK(shown({12300, 5e-12}) == "12300 +- 0");  // rounding
    CHECK(value_json({1.0 / 3, 0.25}).dump() == R"({"error":0.25,"value":0.333333})");
}

TEST_CASE("numbers stand at the right of their columns", "[output]") {
    CHECK(padded("12 %", 6) == "  12 %");
    CHECK(padded("1234 %", 4) == "1234 %");
}

TEST_CASE("texts are cells of CSV", "[output]") {
    CHECK(csv_cell("desk") == "desk");
    CHECK(csv_cell("a, \"b\"") == "\"a, \"\"b\"\"\"");
}

}  // namespace candelabra
