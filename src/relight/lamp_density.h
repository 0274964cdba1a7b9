// SPDX-License-Identifier: GPL-3.0-or-later
// Light along the list of lamps: of ranges, shared by the powers of their lamps, and of single
// lamps. So light that tiles keep by different nodes can be added, and divided anew.
#pragma once

#include "base/rgb.h"
#include "relight/lamp_list.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// The powers of all lamps before each place of the list, and of all.
std::vector<double> powers_before(const LampList&);

class LampDensity {
public:
    /// `before`: powers_before(); it must outlive the light.
    explicit LampDensity(std::span<const double> before) : before_(before) {}

    void add(const LampRange&, const Rgb& light);

    /// To be called between the last add() and the first question.
    void settle();

    /// The light of the lamps of a range.
    Rgb light(const LampRange&) const;
    /// Whether its lamps share the light of the range by their powers.
    bool is_even(const LampRange&) const;

private:
    struct Step {
        std::uint32_t at;  ///< place from which on...
        Rgb slope;         ///< ...there is so much light for a unit of power,
        Rgb light;         ///< and so much before it; both are sums after settle()
    };
    struct Single {
        std::uint32_t lamp;
        Rgb light;  ///< after settle(): with that of all before it
    };

    void sum_singles();
    Rgb light_before(std::uint32_t place) const;

    std::span<const double> before_;
    std::vector<Step> steps_;
    std::vector<Single> singles_;
};

/// Returns at most `most` disjoint ranges with all light: those with much of it are divided first,
/// where the list divides them, unless they are even.
std::vector<LampRange> divided(const LampDensity&, const LampList&, std::size_t most);

}  // namespace candelabra
