// SPDX-License-Identifier: GPL-3.0-or-later
// Checks internal functions of the table against values that POV-Ray 3.7 prints.
#pragma once

#include "formula/internal.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace candelabra {

/// Calls the function with this name; the arguments start with x, y, z.
inline double value_of(std::string_view name, const std::vector<double>& arguments) {
    const auto all = internal_functions();
    const auto found = std::ranges::find(all, name, &InternalFunction::name);
    REQUIRE(found != all.end());
    REQUIRE(arguments.size() == static_cast<std::size_t>(found->parameters));
    return found->code(arguments.data());
}

struct ExpectedValue {
    std::string_view name;
    std::vector<double> parameters;
    double value;
};

/// Checks the functions at the point (0.31, 0.42, -0.57), to 8 digits.
inline void check_values(std::initializer_list<ExpectedValue> expected) {
    for (const ExpectedValue& e : expected) {
        INFO(e.name);
        std::vector<double> arguments = {0.31, 0.42, -0.57};
        arguments.insert(arguments.end(), e.parameters.begin(), e.parameters.end());
        CHECK(value_of(e.name, arguments) == Approx(e.value).margin(6e-9).epsilon(0));
    }
}

}  // namespace candelabra
