// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/sample_turns.h"

#include <numeric>

namespace candelabra {

namespace {

/// Steps from one sample's item to the next one's: about the golden section of the items, so that
/// few samples are spread evenly, and without a common divisor with their number, so that all come.
std::uint32_t steps_among(std::uint32_t count) {
    constexpr double golden_section = 0.6180339887498949;
    const auto middle = static_cast<std::uint32_t>(golden_section * count + 0.5);
    std::uint32_t away = 0;
    const auto fits = [&](std::uint32_t steps) { return std::gcd(steps, count) == 1; };
    while (!fits(middle - away) && !fits(middle + away)) ++away;
    return fits(middle - away) ? middle - away : middle + away;
}

}  // namespace

std::uint32_t item_in_turn(Turns turns, std::uint32_t count, const Key& key) {
    if (count == 1) return 0;
    const std::uint64_t first = mix(mix(key.pixel) + static_cast<std::uint64_t>(turns));
    const std::uint64_t steps = std::uint64_t{key.sample} * steps_among(count);
    return static_cast<std::uint32_t>((first % count + steps) % count);
}

}  // namespace candelabra
