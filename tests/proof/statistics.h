// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two pictures with independent noise have the same mean, over batches with other seeds.
// The statistic of a region is T = sum D / sqrt(sum D^2) over the differences D of its pixels. If
// noise is symmetric, P(|T| > t) <= 2 exp(-t^2 / 2) whatever its distribution (Efron 1969). Where
// it is skewed, or shared by pixels, T may be large by chance; then the batches tell, whose means
// are independent: see BatchSpread.
#pragma once

#include "base/image.h"

#include <array>
#include <cstddef>
#include <vector>

namespace candelabra::proof {

/// Blocks of the picture across and down; each is a region, and so is the whole picture.
inline constexpr int blocks = 4;
inline constexpr std::size_t regions = (blocks * blocks + 1) * 3;  ///< of each channel
inline constexpr std::size_t whole = blocks * blocks;

struct Spread {
    double t = 0;       ///< of the mean of batches, in standard errors
    int same_sign = 0;  ///< batches whose difference has the sign of the sum
};

class Comparison {
public:
    /// Differences below `tolerance` times the light of both pictures do not count.
    explicit Comparison(double tolerance) : tolerance_(tolerance) {}

    void add(const Image& left, const Image& right);

    /// T of a region, towards 0 by the tolerance; infinite if a value is no number.
    double t(std::size_t region) const;
    /// The region with the greatest |T|.
    std::size_t worst() const;
    /// The same statistic from the sums of batches.
    Spread spread(std::size_t region) const;
    /// Whether one picture is black in a region because it may have missed what the other one has:
    /// light that comes in by less than a few contributions as bright as the brightest pixel. Such
    /// a picture has no noise that would tell. `samples`: of each pixel.
    bool too_rare(std::size_t region, int samples) const;
    /// The same of a right picture that finds light by chance, beside other light that it does not
    /// miss: all that it lacks may be such contributions, and its batches show none of them.
    bool lacks_rare(std::size_t region, int samples) const;
    double left(std::size_t region) const { return sums_[region].left; }
    double right(std::size_t region) const { return sums_[region].right; }
    std::size_t batches() const { return batches_; }

private:
    struct Sums {
        double left = 0, right = 0, squares = 0;
        std::vector<double> batches = {}, of_right = {};  ///< differences; the right picture's
    };
    double beyond(const Sums&) const;
    bool is_rare(double sum, int samples) const;

    double tolerance_;
    std::array<Sums, regions> sums_{};
    std::size_t batches_ = 0;
    double brightest_ = 0;  ///< of all pixels
};

}  // namespace candelabra::proof
