// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the samples of each pixel: their sum, and their deviation in display values. All sums
// are exact, so that parts of a picture can be added in any order.
#pragma once

#include "base/exact_sum.h"
#include "base/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// The samples of one pixel.
struct PixelSum {
    std::array<ExactSum, 3> radiance;
    /// Sums of the display values from 0 to 1 in units of 2^-20, and of their squares.
    std::array<std::uint64_t, 3> display{};
    std::array<std::uint64_t, 3> display_squared{};
    std::uint32_t samples = 0;
    std::uint32_t target = 0;       ///< number of samples wanted so far
    std::uint32_t shadow_rays = 0;  ///< of its samples, modulo 2^32
    std::uint32_t negative = 0;     ///< number of samples subtracted where the filter is negative

    /// `negative`: subtracts the sample. `exposure`: the factor on the radiance for display.
    void add(const Vec3& sample, bool negative = false, double exposure = 1);
    void add(const PixelSum& other);
    /// Returns the divisor that turns sums into means; 0 if there are no samples.
    double weight() const { return samples - 2.0 * negative; }
    /// Returns the mean for a sum of the samples, or 0 without samples.
    double mean_of(double sum) const { return weight() > 0 ? sum / weight() : 0; }
    Vec3 mean() const;
    /// Standard deviation of one sample in display values, summed over the channels. Needs two
    /// samples.
    double deviation() const;
    /// Greatest variance of a channel's mean, in display values; 0 with fewer than two samples.
    double variance_of_mean() const;

    friend bool operator==(const PixelSum&, const PixelSum&) = default;

private:
    /// Returns the variance of one sample's display value.
    double variance(std::size_t channel) const;
};

class Film {
public:
    Film() = default;
    /// `aovs`: number of further sums per pixel (see transport/aovs.h).
    Film(int width, int height, std::size_t aovs = 0);
    int width() const { return width_; }
    int height() const { return height_; }
    PixelSum& at(int x, int y) { return pixels_[index(x, y)]; }
    const PixelSum& at(int x, int y) const { return pixels_[index(x, y)]; }
    /// Returns the number of the pixel, counted row by row from the top.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    std::vector<PixelSum>& pixels() { return pixels_; }
    const std::vector<PixelSum>& pixels() const { return pixels_; }
    std::size_t aovs() const { return extras_; }
    /// Returns the further sums of a pixel by its number.
    std::span<ExactSum> extra(std::size_t pixel) {
        return std::span(sums_).subspan(pixel * extras_, extras_);
    }
    std::span<const ExactSum> extra(std::size_t pixel) const {
        return std::span(sums_).subspan(pixel * extras_, extras_);
    }
    /// Adds the samples of a pixel of another film with the same size and aovs.
    void add(std::size_t pixel, const Film& other);
    /// Returns the means of the samples; black where there are none.
    Image image() const;

    friend bool operator==(const Film&, const Film&) = default;

private:
    int width_ = 0, height_ = 0;
    std::vector<PixelSum> pixels_;
    std::size_t extras_ = 0;
    std::vector<ExactSum> sums_;  ///< aovs, pixel by pixel
};

}  // namespace candelabra
