// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the samples of each pixel: their sum, and how much they differ as a viewer would see it.
#pragma once

#include "base/image.h"

#include <cstdint>
#include <vector>

/// One pixel's samples.
struct PixelSum {
    Vec3 radiance = Vec3(0);  ///< sum
    Vec3 display = Vec3(0);   ///< sum of values as a display shows them, 0..1
    Vec3 display_squared = Vec3(0);
    std::uint32_t samples = 0;

    void add(const Vec3& sample);
    /// Standard deviation of one sample in display values, summed over the channels. Needs two
    /// samples.
    double deviation() const;
};

class Film {
public:
    Film(int width, int height);
    int width() const { return width_; }
    int height() const { return height_; }
    PixelSum& at(int x, int y) { return pixels_[index(x, y)]; }
    const PixelSum& at(int x, int y) const { return pixels_[index(x, y)]; }
    /// Number of the pixel, row by row from the top.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    /// Means of the samples; black where there are none.
    Image image() const;

private:
    int width_, height_;
    std::vector<PixelSum> pixels_;
};
