// SPDX-License-Identifier: GPL-3.0-or-later
// Words of a parameter's contract that are names elsewhere: `#macro Ring(Count whole >= 1)`. They
// stand behind the parameter without a comma.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace candelabra {

constexpr bool is_contract_word(std::string_view word) {
    constexpr auto words =
        std::array<std::string_view, 5>{"number", "whole", "vector", "string", "or"};
    return std::ranges::find(words, word) != words.end();
}

}  // namespace candelabra
