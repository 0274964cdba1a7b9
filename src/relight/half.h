// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of 16 bits (binary16 of IEEE 754), in which light is kept. Only finite ones are used.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace candelabra {

inline constexpr float greatest_half = 65504;

/// Rounds to the nearest one, to even ones if two are as near; NaN becomes 0.
inline std::uint16_t to_half(float value) {
    if (!(value == value)) return 0;
    const std::uint32_t sign = std::bit_cast<std::uint32_t>(value) >> 16 & 0x8000U;
    const float size = std::min(value < 0 ? -value : value, greatest_half);
    std::uint32_t half = 0;
    if (size < 0x1p-14F) {
        // The addition rounds to a multiple of 2^-24.
        half = std::bit_cast<std::uint32_t>(size + 0.5F) - std::bit_cast<std::uint32_t>(0.5F);
    } else {
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(size) - (112U << 23);
        half = (bits + 0x0FFFU + (bits >> 13 & 1U)) >> 13;
    }
    return static_cast<std::uint16_t>(sign | half);
}

/// Precondition: it is finite.
inline float from_half(std::uint16_t half) {
    const std::uint32_t bits = (half & 0x8000U) << 16 | (half & 0x7FFFU) << 13;
    return std::bit_cast<float>(bits) * 0x1p112F;
}

/// Whether it is neither infinite nor NaN.
inline bool is_finite_half(std::uint16_t half) { return (half & 0x7C00U) != 0x7C00U; }

}  // namespace candelabra
