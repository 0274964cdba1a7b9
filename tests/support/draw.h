// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, points and directions for tests: the same in every run.
#pragma once

#include "base/random.h"
#include "base/vector.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace candelabra {

class Draw {
public:
    explicit Draw(std::uint64_t seed) : key_{mix(seed)} {}

    /// Uniform in [0, 1).
    double number() {
        ++key_.pixel;
        return uniform(key_, Purpose::light_u);
    }
    double between(double low, double high) { return low + number() * (high - low); }
    /// Uniform in the cube of this half width around the origin.
    Vec3 point(double half = 1) {
        const double x = between(-half, half), y = between(-half, half);
        return {x, y, between(-half, half)};
    }
    /// Uniform on the unit sphere.
    Vec3 direction() {
        const double z = between(-1, 1), angle = between(0, 2 * std::numbers::pi);
        return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
    }

    /// Weights of any range, some of them 0.
    std::vector<double> weights(std::size_t count) {
        std::vector<double> result;
        for (std::size_t i = 0; i < count; ++i)
            result.push_back(number() < 0.1 ? 0 : std::pow(10, between(-30, 30)));
        return result;
    }

private:
    Key key_;
};

}  // namespace candelabra
