// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the samples of each pixel: their sum, and their deviation in display values. All sums
// are exact, so that parts of a picture can be added in any order.
#pragma once

#include "base/exact_sum.h"
#include "base/image.h"
#include "base/zeroed_pages.h"

#include <array>
#include <cstdint>
#include <span>

namespace candelabra {

/// The samples of one pixel.
struct PixelSum {
    std::array<ExactSum, 3> radiance;
    /// Sums of the display values from 0 to 1 in units of 2^-20, and of their squares.
    std::array<std::uint64_t, 3> display{};
    std::array<std::uint64_t, 3> display_squared{};
    std::uint32_t samples = 0;
    std::uint32_t planned = 0;      ///< number of samples wanted so far
    std::uint32_t shadow_rays = 0;  ///< of its samples, modulo 2^32
    std::uint32_t negative = 0;     ///< number of samples subtracted where the filter is negative

    /// `negative`: subtracts the sample. `exposure`: the factor on the radiance for display.
    void add(const Rgb& sample, bool negative = false, double exposure = 1);
    void add(const PixelSum& other);
    /// Returns the divisor that turns sums into means; 0 if there are no samples.
    double weight() const { return samples - 2.0 * negative; }
    /// Returns the mean for a sum of the samples, or 0 without samples.
    double mean_of(double sum) const { return weight() > 0 ? sum / weight() : 0; }
    Rgb mean() const;
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
    /// The same with its sums in these pages, which are zero and have bytes_of() of it.
    Film(int width, int height, std::size_t aovs, ZeroedPages);
    static std::size_t bytes_of(int width, int height, std::size_t aovs);
    /// A copy lies in memory, wherever the original does.
    Film(const Film&);
    Film& operator=(const Film&);
    Film(Film&&) = default;
    Film& operator=(Film&&) = default;
    ~Film() = default;

    int width() const { return width_; }
    int height() const { return height_; }
    PixelSum& at(int x, int y) { return pixels()[index(x, y)]; }
    const PixelSum& at(int x, int y) const { return pixels()[index(x, y)]; }
    /// Returns the number of the pixel, counted row by row from the top.
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    std::span<PixelSum> pixels() { return {static_cast<PixelSum*>(pages_.data()), count_}; }
    std::span<const PixelSum> pixels() const {
        return {static_cast<const PixelSum*>(pages_.data()), count_};
    }
    std::size_t aovs() const { return extras_; }
    /// Returns the further sums of a pixel by its number.
    std::span<ExactSum> extra(std::size_t pixel) { return {sums() + pixel * extras_, extras_}; }
    std::span<const ExactSum> extra(std::size_t pixel) const {
        return {sums() + pixel * extras_, extras_};
    }
    /// Notes that pixels get samples, done and planned, only in the rows from `first` to before
    /// `last`, which are clipped to the film: walks leave out the others, so that these take no
    /// memory.
    void keep_to_rows(int first, int last);
    int first_row() const { return first_row_; }
    int last_row() const { return last_row_; }
    /// Calls use(number) for the pixels of these rows in order. Of a film in a file, it lets go of
    /// those behind.
    template <class Use>
    void each(const Use& use) const {
        for (std::size_t i = index(0, first_row_); i < index(0, last_row_); ++i) {
            use(i);
            if (i % held_pixels == held_pixels - 1) let_go();
        }
    }
    /// Leaves the sums to the file that they lie in, if they do (ZeroedPages::let_go()). To be
    /// called after the use of about held_pixels.
    void let_go() const { pages_.let_go(); }
    static constexpr std::size_t held_pixels = std::size_t{1} << 18;

    /// Adds the samples of a pixel of another film with the same size and aovs.
    void add(std::size_t pixel, const Film& other);
    /// Returns the means of the samples; black where there are none.
    Image image() const;

    friend bool operator==(const Film&, const Film&);

private:
    ExactSum* sums() const {
        return reinterpret_cast<ExactSum*>(static_cast<PixelSum*>(pages_.data()) + count_);
    }

    int width_ = 0, height_ = 0;
    int first_row_ = 0, last_row_ = 0;
    std::size_t count_ = 0, extras_ = 0;
    ZeroedPages pages_;  ///< the pixels, and behind them their further sums, pixel by pixel
};

}  // namespace candelabra
