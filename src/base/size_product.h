// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes that files and options ask for. In WebAssembly std::size_t has 32 bits, so a product of
// such numbers must not wrap around to a size that is there.
#pragma once

#include <concepts>
#include <limits>

namespace candelabra {

/// The product; the greatest number where it has no room, which no memory and no file has.
template <std::unsigned_integral Size, std::same_as<Size>... Others>
constexpr Size size_product(Size first, Others... others) {
    Size product = first;
    const auto times = [&](Size factor) {
        return !__builtin_mul_overflow(product, factor, &product);
    };
    return (times(others) && ...) ? product : std::numeric_limits<Size>::max();
}

}  // namespace candelabra
