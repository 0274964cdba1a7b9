// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/decimal.h"

#include <catch2/catch.hpp>

#include <string>

namespace candelabra {

TEST_CASE("numbers beyond a double's range are too small or too large", "[text]") {
    struct Row {
        std::string number;
        bool small;
    };
    const std::string zeros(330, '0');
    const Row rows[] = {
        {"1e-400", true},
        {"1e400", false},
        {"1E+400", false},
        {"0." + zeros + "1", true},
        {"1" + zeros, false},
        {"1" + zeros + ".5", false},
        {"0." + zeros + "1e100", true},
        {"0." + zeros + "1e700", false},
        {"1" + zeros + "e-700", true},
        {"1" + zeros + "e-10", false},
        {"1e-99999999999999999999", true},
        {"1e99999999999999999999", false},
        {"." + zeros + "1e", true},
    };
    for (const Row& row : rows) {
        CAPTURE(row.number);
        CHECK(underflows(row.number) == row.small);
    }
}

TEST_CASE("a finite number fills its text") {
    CHECK(finite_number("1.5") == 1.5);
    CHECK(finite_number("-2e3") == -2000.0);
    for (const char* text : {"", "1.5x", " 1", "1 ", "+1", "nan", "inf", "-inf", "1e999", "0x10"}) {
        CAPTURE(text);
        CHECK_FALSE(finite_number(text));
    }
}

}  // namespace candelabra
