// SPDX-License-Identifier: GPL-3.0-or-later
// Means of the factors on lamps over nodes of the list of lamps.
#pragma once

#include "base/rgb.h"
#include "relight/lamp_list.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace candelabra {

/// Red, green and blue.
using Channels = std::array<float, 3>;

inline Channels channels(const Rgb& factor) {
    return {static_cast<float>(factor.r), static_cast<float>(factor.g),
            static_cast<float>(factor.b)};
}

/// Means of the factors over ranges of lamps, by the powers of the lamps.
class FactorMeans {
public:
    FactorMeans(const LampList& lamps, std::span<const Rgb> factors) : sums_(1) {
        sums_.reserve(factors.size() + 1);
        for (std::size_t i = 0; i < factors.size(); ++i) {
            const double power = lamps.powers()[i];
            Sum next = sums_.back();
            next.power += power;
            next.light += power * factors[i];
            sums_.push_back(next);
        }
    }

    Rgb operator()(const LampRange& range) const {
        const Sum &first = sums_[range.first], &last = sums_[range.last];
        return (last.light - first.light) / (last.power - first.power);
    }

private:
    struct Sum {
        double power = 0;
        Rgb light = Rgb(0);
    };
    std::vector<Sum> sums_;
};

}  // namespace candelabra
