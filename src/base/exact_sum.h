// SPDX-License-Identifier: GPL-3.0-or-later
// A sum of many numbers that does not depend on their order: each is rounded once, to a multiple of
// 2^-52, and added as an integer. Samples may therefore be taken by any thread, process or machine,
// and still make the same picture. Used by the film.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace candelabra {

class ExactSum {
public:
    __extension__ using Wide = __int128;

    /// Larger values are clamped to this; NaN counts as 0. 2^31 such values fit.
    static constexpr double greatest = 0x1p44;

    void add(double value) {
        if (std::isnan(value)) return;
        const double scaled = std::clamp(value, -greatest, greatest) * 0x1p52;
        // Usual colours fit into a word, which machines convert in one instruction.
        const bool usual = std::abs(scaled) < 0x1p63;
        sum_ += usual ? static_cast<std::int64_t>(scaled) : static_cast<Wide>(scaled);
    }
    void add(const ExactSum& other) { sum_ += other.sum_; }
    void subtract(const ExactSum& other) { sum_ -= other.sum_; }
    double value() const { return static_cast<double>(sum_) * 0x1p-52; }

    /// Four groups of 32 bits, lowest first: the format of sums in files.
    std::uint32_t word(int i) const { return static_cast<std::uint32_t>(sum_ >> (32 * i)); }
    void set_word(int i, std::uint32_t bits) {
        __extension__ using Bits = unsigned __int128;
        const Bits kept = static_cast<Bits>(sum_) & ~(Bits{0xffffffffu} << (32 * i));
        sum_ = static_cast<Wide>(kept | Bits{bits} << (32 * i));
    }

    friend bool operator==(const ExactSum&, const ExactSum&) = default;

private:
    Wide sum_ = 0;
};

}  // namespace candelabra
