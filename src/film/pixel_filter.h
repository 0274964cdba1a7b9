// SPDX-License-Identifier: GPL-3.0-or-later
// How samples count in the pixel that they are around. Each pixel has samples of its own, spread as
// densely as the filter is high, so that pixels need nothing of each other: pictures are stopped,
// shared and joined as with the box.
#pragma once

#include "base/random.h"
#include "base/vector.h"
#include "camera/film_settings.h"

#include <array>
#include <cstdint>

namespace candelabra {

/// A sample's place and sign.
struct FilteredPlace {
    Vec2 place;             ///< from the pixel's left and upper edge, in pixels
    bool negative = false;  ///< the filter is below 0 there: the sample is subtracted
};

/// box: the pixel alone. triangle: 1 pixel to each side. mitchell: B = C = 1/3 of D. Mitchell and
/// A. Netravali (1988), 2 pixels to each side, below 0 beyond 8/7; sharper than the others.
/// blackman_harris: the window of four terms of F. Harris (1978), 1.5 pixels to each side.
class PixelFilter {
public:
    explicit PixelFilter(FilterShape);

    bool is_box() const { return shape_ == FilterShape::box; }

    /// Of the sample of a key. Which samples are negative depends on their number only, so that all
    /// pixels have the same share of them. Those of each sign are spread evenly among themselves.
    FilteredPlace place(const Key&) const;

    /// The filter's height, in one direction, at a distance in pixels; its integral is 1.
    static double height(FilterShape, double distance);

private:
    static constexpr int parts = 1024;

    /// A part of the filter in one direction that has one sign, as shares of it from its left end.
    struct Lobes {
        std::array<double, parts + 1> sums = {};
        double all = 0;  ///< the integral of its size
        double reach = 0;
        double at(double share) const;
    };
    static Lobes lobes(FilterShape, bool negative);
    /// So many of the first samples are negative.
    std::uint32_t negatives_among(std::uint32_t samples) const;

    FilterShape shape_;
    Lobes above_, below_;
    // Of the plane's filter, which is the product of two: where both have one sign it is above 0.
    double both_above_, both_below_, mixed_;
};

}  // namespace candelabra
