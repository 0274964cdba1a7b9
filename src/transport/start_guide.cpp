// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/start_guide.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace candelabra {

namespace {

constexpr double guided = 0.5;

}  // namespace

double StartTrials::sum() const { return std::accumulate(worth_.begin(), worth_.end(), 0.0); }

StartGuide::StartGuide(const StartTrials& trials) {
    const double all = trials.sum();
    if (!(all > 0) || !std::isfinite(all)) return;
    constexpr double even = (1 - guided) / StartTrials::cells;
    std::array<double, StartTrials::cells> weights{};
    std::ranges::transform(trials.worth_, weights.begin(),
                           [&](double worth) { return even + guided * worth / all; });
    cells_ = WeightedIndex(weights);
}

StartGuide::Drawn StartGuide::draw(const Vec2& u) const {
    if (cells_.size() == 0) return {u, 1};
    const double total = static_cast<double>(cells_.total());
    const std::uint32_t cell = cells_.at_share(u.x);
    const double of_cell = static_cast<double>(cells_.of(cell));
    return {StartTrials::place(cell, {cells_.within(cell, u.x), u.y}),
            total / (of_cell * StartTrials::cells)};
}

}  // namespace candelabra
