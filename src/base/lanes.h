// SPDX-License-Identifier: GPL-3.0-or-later
// Eight single-precision numbers, and operations on them for vectorised loops. They are compiled
// into the loops that CANDELABRA_TARGET_CLONES marks, for each instruction set. Used by the index
// of boxes and by the packs of its leaves.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace candelabra {

inline constexpr std::size_t lane_count = 8;

using Lanes [[gnu::vector_size(sizeof(float) * lane_count)]] = float;
/// All bits set, or none, in each lane.
using Marks [[gnu::vector_size(sizeof(float) * lane_count)]] = std::int32_t;

[[gnu::always_inline]] inline Lanes lanes_of(float x) {
    // One instruction where the machine has one; a vector of eight would be filled one by one.
    using Four [[gnu::vector_size(4 * sizeof(float))]] = float;
    const Four four{x, x, x, x};
    return __builtin_shufflevector(four, four, 0, 0, 0, 0, 0, 0, 0, 0);
}

/// Loads from any address, whatever type is stored there.
[[gnu::always_inline]] inline Lanes load_lanes(const void* from) {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// These return the second operand if the first one is NaN. For any vector type.
template <class Vector>
[[gnu::always_inline]] inline Vector min_of(const Vector& a, const Vector& b) {
    return a < b ? a : b;
}
template <class Vector>
[[gnu::always_inline]] inline Vector greatest_of(const Vector& a, const Vector& b) {
    return a > b ? a : b;
}

/// Returns a bit for each marked lane.
[[gnu::always_inline]] inline std::uint32_t marked(const Marks& marks) {
#ifdef __x86_64__
    // Every machine of this kind has this instruction; going through memory takes twice as long.
    using Four [[gnu::vector_size(4 * sizeof(float))]] = float;
    const auto low = std::bit_cast<Four>(__builtin_shufflevector(marks, marks, 0, 1, 2, 3));
    const auto high = std::bit_cast<Four>(__builtin_shufflevector(marks, marks, 4, 5, 6, 7));
    return static_cast<std::uint32_t>(__builtin_ia32_movmskps(low) | __builtin_ia32_movmskps(high)
                                                                         << 4);
#else
    constexpr Marks bits = {1, 2, 4, 8, 16, 32, 64, 128};
    const auto quarters = std::bit_cast<std::array<std::uint64_t, 4> >(marks & bits);
    const std::uint64_t pairs = (quarters[0] | quarters[2]) | (quarters[1] | quarters[3]);
    return static_cast<std::uint32_t>(pairs | pairs >> 32);
#endif
}

}  // namespace candelabra
