// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel light through a ball of glass, by exact geometry: what tests of photons are compared
// with.
#pragma once

#include <cmath>

namespace candelabra {

/// A ball of radius 1 whose middle is `height` above a floor, lit along the vertical.
struct BallLens {
    double ior = 1.5, height = 5;

    /// Where on the floor light comes to that enters the ball so far from the axis: below 0 beyond
    /// the axis, infinitely far away where it goes up.
    double place(double entered) const {
        const double outside = std::asin(entered), inside = std::asin(entered / ior);
        const double turned = 2 * (outside - inside);
        if (turned >= M_PI / 2) return INFINITY;
        const double exit = M_PI + outside - 2 * inside;  // from the top of the ball
        return std::sin(exit) - (std::cos(exit) + height) * std::tan(turned);
    }

    /// The share of light that comes to the floor within a distance of the axis, as an area of the
    /// light before.
    double area_within(double distance) const {
        double sum = 0;
        constexpr int rings = 100000;
        for (int i = 0; i < rings; ++i) {
            const double entered = (i + 0.5) / rings;
            if (std::abs(place(entered)) < distance) sum += 2 * M_PI * entered / rings;
        }
        return sum;
    }

    /// How many times denser than before light lies on the floor, on average between two distances
    /// of the axis.
    double density(double from, double to) const {
        return (area_within(to) - area_within(from)) / (M_PI * (to * to - from * from));
    }
};

}  // namespace candelabra
