// SPDX-License-Identifier: GPL-3.0-or-later
// Estimates by independent batches of samples, with the intervals that hold the true values in 95
// of 100 cases.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace candelabra {

/// Number of batches of every estimate.
inline constexpr std::size_t batch_count = 16;
using Batches = std::array<double, batch_count>;

struct MeterValue {
    double value = 0;
    double error = 0;  ///< half of the width of the interval
};

/// The estimate for results of batches that are equally good. `value`: that of all samples
/// together, of which the batches tell the spread.
MeterValue with_interval(double value, const Batches&);

/// The results of all points of a meter.
struct MeterSummary {
    std::size_t least = 0, greatest = 0;  ///< points
    MeterValue min, mean, max;
    MeterValue uo, ud;  ///< min / mean and min / max
};

/// `values`: of all samples of each point, at least one; `batches`: the same of each batch. Which
/// points are least and greatest follows from all samples, so the least is too low by a part of its
/// interval.
MeterSummary summary_of(std::span<const double> values, std::span<const Batches> batches);

}  // namespace candelabra
