// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/lamp_density.h"

#include "base/order.h"

#include <algorithm>

namespace candelabra {

namespace {

struct DenseRange {
    double light;
    LampRange range;

    bool operator<(const DenseRange& other) const {
        return light < other.light || (light == other.light && range.first > other.range.first);
    }
};

}  // namespace

std::vector<double> powers_before(const LampList& lamps) {
    std::vector<double> before = {0};
    before.reserve(std::size_t{lamps.size()} + 1);
    for (const float power : lamps.powers())
        before.push_back(before.back() + static_cast<double>(power));
    return before;
}

void LampDensity::add(const LampRange& range, const Rgb& light) {
    if (range.size() == 1) return singles_.push_back({range.first, light});
    const Rgb slope = light / (before_[range.last] - before_[range.first]);
    steps_.push_back({range.first, slope, Rgb(0)});
    steps_.push_back({range.last, -slope, Rgb(0)});
}

void LampDensity::settle() {
    sort_stably(steps_, {}, &Step::at);
    std::size_t count = 0;
    for (const Step& step : steps_) {
        if (count > 0 && steps_[count - 1].at == step.at) {
            steps_[count - 1].slope += step.slope;
            continue;
        }
        Step next = step;
        if (count > 0) {
            const Step& last = steps_[count - 1];
            next.light = last.light + last.slope * (before_[step.at] - before_[last.at]);
            next.slope += last.slope;
        }
        steps_[count++] = next;
    }
    steps_.resize(count);
    sum_singles();
}

/// Sums the light of single lamps from the first one on, without what has been taken away again.
void LampDensity::sum_singles() {
    constexpr double rounding = 1e-9;
    sort_stably(singles_, {}, &Single::lamp);
    std::size_t count = 0;
    for (std::size_t i = 0; i < singles_.size();) {
        Single sum{singles_[i].lamp, Rgb(0)};
        double size = 0;
        for (; i < singles_.size() && singles_[i].lamp == sum.lamp; ++i) {
            sum.light += singles_[i].light;
            size += max_abs_component(singles_[i].light);
        }
        if (max_abs_component(sum.light) <= rounding * size) continue;
        if (count > 0) sum.light += singles_[count - 1].light;
        singles_[count++] = sum;
    }
    singles_.resize(count);
}

Rgb LampDensity::light_before(std::uint32_t place) const {
    Rgb light(0);
    const auto step = std::ranges::upper_bound(steps_, place, {}, &Step::at);
    if (step != steps_.begin())
        light += step[-1].light + step[-1].slope * (before_[place] - before_[step[-1].at]);
    const auto single = std::ranges::lower_bound(singles_, place, {}, &Single::lamp);
    if (single != singles_.begin()) light += single[-1].light;
    return light;
}

Rgb LampDensity::light(const LampRange& range) const {
    return light_before(range.last) - light_before(range.first);
}

bool LampDensity::is_even(const LampRange& range) const {
    if (range.size() == 1) return true;
    const auto step = std::ranges::upper_bound(steps_, range.first, {}, &Step::at);
    if (step != steps_.end() && step->at < range.last) return false;
    const auto single = std::ranges::lower_bound(singles_, range.first, {}, &Single::lamp);
    return single == singles_.end() || single->lamp >= range.last;
}

std::vector<LampRange> divided(const LampDensity& density, const LampList& lamps,
                               std::size_t most) {
    std::vector<LampRange> chosen;
    std::vector<DenseRange> open;
    const auto take = [&](const LampRange& range) {
        const double light = max_abs_component(density.light(range));
        if (!(light > 0)) return;
        if (density.is_even(range))
            chosen.push_back(range);
        else
            add_to_heap(open, DenseRange{light, range});
    };
    if (lamps.size() > 0) take({0, lamps.size()});
    while (!open.empty() && chosen.size() + open.size() < most) {
        const LampRange range = open.front().range;
        remove_greatest(open);
        const std::uint32_t middle = lamps.division_of(range);
        take({range.first, middle});
        take({middle, range.last});
    }
    for (const DenseRange& each : open) chosen.push_back(each.range);
    sort_stably(chosen, {}, &LampRange::first);
    return chosen;
}

}  // namespace candelabra
