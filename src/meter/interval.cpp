// SPDX-License-Identifier: GPL-3.0-or-later
#include "meter/interval.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Quantile 0.975 of Student's t distribution with 15 degrees of freedom.
constexpr double t_of_batches = 2.1314495;
static_assert(batch_count == 16);

}  // namespace

MeterValue with_interval(double value, const Batches& batches) {
    constexpr double count = batch_count;
    double mean = 0, squares = 0;
    for (const double each : batches) mean += each / count;
    for (const double each : batches) squares += (each - mean) * (each - mean);
    return {value, t_of_batches * std::sqrt(squares / (count - 1) / count)};
}

MeterSummary summary_of(std::span<const double> values, std::span<const Batches> batches) {
    MeterSummary summary;
    const auto number_of = [&](auto place) {
        return static_cast<std::size_t>(place - values.begin());
    };
    summary.least = number_of(std::ranges::min_element(values));
    summary.greatest = number_of(std::ranges::max_element(values));
    double sum = 0;
    Batches means{};
    for (std::size_t i = 0; i < values.size(); ++i) {
        sum += values[i];
        for (std::size_t b = 0; b < batch_count; ++b) means[b] += batches[i][b];
    }
    const auto count = static_cast<double>(values.size());
    for (double& each : means) each /= count;
    const Batches& low = batches[summary.least];
    const Batches& high = batches[summary.greatest];
    const auto over = [](double part, double whole) { return whole != 0 ? part / whole : 0; };
    const auto ratio = [&](double part, double whole, const Batches& parts, const Batches& wholes) {
        Batches ratios{};
        for (std::size_t b = 0; b < batch_count; ++b) ratios[b] = over(parts[b], wholes[b]);
        return with_interval(over(part, whole), ratios);
    };
    const double min = values[summary.least], max = values[summary.greatest], mean = sum / count;
    summary.min = with_interval(min, low);
    summary.mean = with_interval(mean, means);
    summary.max = with_interval(max, high);
    summary.uo = ratio(min, mean, low, means);
    summary.ud = ratio(min, max, low, high);
    return summary;
}

}  // namespace candelabra
