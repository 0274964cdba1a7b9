// SPDX-License-Identifier: GPL-3.0-or-later
// The filter by which samples contribute to a pixel. Each pixel has its own samples, distributed in
// proportion to the filter, so that pixels are independent: pictures can be stopped, divided and
// merged as with the box filter.
#pragma once

#include "base/random.h"
#include "base/vector.h"
#include "camera/film_settings.h"

#include <array>
#include <cstdint>

namespace candelabra {

/// The position and sign of a sample.
struct FilteredPlace {
    Vec2 place;             ///< from the left and upper edge of the pixel, in pixels
    bool negative = false;  ///< the filter is negative there: the sample is subtracted
};

/// box: the pixel alone. triangle: 1 pixel to each side. mitchell: B = C = 1/3 of D. Mitchell and
/// A. Netravali (1988), 2 pixels to each side, negative beyond 8/7; sharper than the others.
/// blackman_harris: the four-term window of F. Harris (1978), 1.5 pixels to each side.
class PixelFilter {
public:
    explicit PixelFilter(FilterShape);

    bool is_box() const { return shape_ == FilterShape::box; }

    /// Returns the place of a sample. Its sign depends on the sample number only, so that all
    /// pixels have the same fraction of negative samples. Samples of each sign are evenly
    /// distributed.
    FilteredPlace place(const Key&) const;

    /// Returns the one-dimensional filter at a distance in pixels; its integral is 1.
    static double height(FilterShape, double distance);

private:
    static constexpr int parts = 1024;

    /// The positive or negative part of the one-dimensional filter, as a cumulative distribution
    /// from its left end.
    struct Lobes {
        std::array<double, parts + 1> sums = {};
        double all = 0;  ///< the integral of its absolute value
        double reach = 0;
        double at(double share) const;
    };
    static Lobes lobes(FilterShape, bool negative);
    /// Returns the number of negative samples among the first samples.
    std::uint32_t negatives_among(std::uint32_t samples) const;

    FilterShape shape_;
    Lobes above_, below_;
    // Integrals of the two-dimensional filter, a product that is positive where both factors have
    // the same sign.
    double both_above_, both_below_, mixed_;
};

}  // namespace candelabra
