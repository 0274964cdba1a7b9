// SPDX-License-Identifier: GPL-3.0-or-later
// The number of a lamp among all lamps of a world: whatever sends light knows its lamp by this.
#pragma once

#include <cstdint>

namespace candelabra {

/// A luminaire or a box of glowing media, a light source, or the sky.
class Lamp {
public:
    /// The sky, as far as it is a luminaire.
    static constexpr Lamp sky() { return Lamp(sky_bit); }
    /// A number of WorldLights::visit(), below 2^30.
    static constexpr Lamp luminaire(std::uint32_t index) { return Lamp(index); }
    /// Index in WorldLights::sources, below 2^30.
    static constexpr Lamp source(std::uint32_t index) { return Lamp(source_bit | index); }

    constexpr bool is_sky() const { return bits_ == sky_bit; }
    constexpr bool is_source() const { return (bits_ & source_bit) != 0; }
    constexpr bool is_luminaire() const { return !is_sky() && !is_source(); }
    /// Precondition: it is not the sky.
    constexpr std::uint32_t index() const { return bits_ & ~source_bit; }

    friend constexpr bool operator==(Lamp, Lamp) = default;

private:
    static constexpr std::uint32_t sky_bit = 1U << 31, source_bit = 1U << 30;

    constexpr explicit Lamp(std::uint32_t bits) : bits_(bits) {}

    std::uint32_t bits_;
};

}  // namespace candelabra
