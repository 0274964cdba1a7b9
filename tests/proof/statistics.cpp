// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace candelabra::proof {

namespace {

/// Sums of so many roundings are equal within this share of them.
constexpr double sum_rounding = 1e-9;

/// Of the sum of independent numbers, of which there are at least two.
double squared_error(const std::vector<double>& numbers) {
    const auto n = static_cast<double>(numbers.size());
    const double mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / n;
    double squares = 0;
    for (const double each : numbers) squares += (each - mean) * (each - mean);
    return squares * n / (n - 1);
}

}  // namespace

void Comparison::add(const Image& left, const Image& right) {
    ++batches_;
    for (Sums& each : sums_) {
        each.batches.push_back(0);
        each.of_right.push_back(0);
    }
    const auto put = [&](std::size_t region, double a, double b) {
        Sums& sums = sums_[region];
        sums.left += a;
        sums.right += b;
        sums.squares += (a - b) * (a - b);
        sums.batches.back() += a - b;
        sums.of_right.back() += b;
    };
    for (int y = 0; y < left.height; ++y)
        for (int x = 0; x < left.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double a = left.at(x, y)[c], b = right.at(x, y)[c];
                brightest_ = std::max({brightest_, a, b});
                const auto block = static_cast<std::size_t>(y * blocks / left.height * blocks +
                                                            x * blocks / left.width);
                put(block * 3 + static_cast<std::size_t>(c), a, b);
                put(whole * 3 + static_cast<std::size_t>(c), a, b);
            }
}

/// The difference without what the tolerance allows, with its sign.
double Comparison::beyond(const Sums& sums) const {
    const double difference = sums.left - sums.right;
    const double allowed =
        (tolerance_ + sum_rounding) * (std::abs(sums.left) + std::abs(sums.right)) / 2;
    return std::copysign(std::max(std::abs(difference) - allowed, 0.0), difference);
}

double Comparison::t(std::size_t region) const {
    const Sums& sums = sums_[region];
    const double difference = beyond(sums);
    if (!std::isfinite(difference)) return std::numeric_limits<double>::infinity();
    return difference == 0 ? 0 : difference / std::sqrt(sums.squares);
}

/// Whether the probability to miss all contributions of that sum is above 10^-6, if each is as
/// bright as the brightest pixel.
bool Comparison::is_rare(double sum, int samples) const {
    constexpr double sure = 14;
    return sum * samples < sure * brightest_;
}

bool Comparison::too_rare(std::size_t region, int samples) const {
    const Sums& sums = sums_[region];
    return (sums.left == 0 || sums.right == 0) &&
           is_rare(std::abs(sums.left) + std::abs(sums.right), samples);
}

bool Comparison::lacks_rare(std::size_t region, int samples) const {
    // Noise of the right picture, as a fraction of what the missing contributions would make.
    constexpr double noticed = 0.01;
    const Sums& sums = sums_[region];
    const double missing = sums.left - sums.right;
    if (!(missing > 0) || !is_rare(missing, samples) || batches_ < 2) return false;
    return squared_error(sums.of_right) < noticed * missing * brightest_ / samples;
}

std::size_t Comparison::worst() const {
    std::size_t worst = 0;
    for (std::size_t i = 1; i < regions; ++i)
        if (std::abs(t(i)) > std::abs(t(worst))) worst = i;
    return worst;
}

Spread Comparison::spread(std::size_t region) const {
    const Sums& sums = sums_[region];
    const double sum = sums.left - sums.right;
    Spread result;
    for (const double each : sums.batches) result.same_sign += each * sum > 0;
    if (batches_ < 2) return result;
    const double error = std::sqrt(squared_error(sums.batches));
    const double difference = beyond(sums);
    if (!std::isfinite(difference))
        result.t = std::numeric_limits<double>::infinity();
    else if (difference != 0)
        result.t = error > 0 ? difference / error
                             : std::copysign(std::numeric_limits<double>::infinity(), difference);
    return result;
}

}  // namespace candelabra::proof
