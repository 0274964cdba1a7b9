// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/covering.h"

#include <algorithm>
#include <numeric>

namespace candelabra::proof {

namespace {

constexpr int candidates_of_a_row = 12;
/// Levels of one factor that are weighed against each other.
constexpr std::size_t levels_weighed = 12;

}  // namespace

Covering::Covering(std::vector<std::vector<std::size_t>> levels) : levels_(std::move(levels)) {
    for (const auto& each : levels_) {
        first_.push_back(all_);
        pairs_ += all_ * each.size();
        all_ += each.size();
    }
    seen_.resize(all_ * all_);
}

std::size_t Covering::cell(Choice a, Choice b) const {
    return (first_[a.factor] + a.level) * all_ + first_[b.factor] + b.level;
}

/// A level of a pair that no row has, or any level once all pairs are covered.
Covering::Choice Covering::any_fresh(Dice& dice) const {
    const auto any = [&] {
        const std::size_t factor = dice.below(levels_.size());
        return Choice{factor, dice.below(levels_[factor].size())};
    };
    for (int tries = 0; tries < 1000; ++tries) {
        const Choice a = any(), b = any();
        if (a.factor != b.factor && fresh(a, b)) return a;
    }
    return any();
}

std::size_t Covering::gain(const std::vector<Choice>& row, Choice more) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(row, [&](Choice each) { return fresh(each, more); }));
}

std::size_t Covering::gain(const std::vector<Choice>& row) const {
    std::size_t sum = 0;
    for (const Choice& each : row)
        for (const Choice& other : row) sum += each.factor < other.factor && fresh(each, other);
    return sum;
}

std::vector<Covering::Choice> Covering::candidate(Dice& dice) const {
    std::vector<Choice> row = {any_fresh(dice)};
    std::vector<std::size_t> order(levels_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    dice.shuffle(order);
    for (const std::size_t factor : order) {
        if (factor == row.front().factor) continue;
        const std::size_t count = levels_[factor].size();
        Choice best{factor, dice.below(count)};
        std::size_t best_gain = gain(row, best);
        for (std::size_t i = 1; i < std::min(count, levels_weighed); ++i) {
            const Choice other{factor, dice.below(count)};
            const std::size_t other_gain = gain(row, other);
            if (other_gain > best_gain) best = other, best_gain = other_gain;
        }
        row.push_back(best);
    }
    return row;
}

Row Covering::next(Dice& dice) const {
    std::vector<Choice> best = candidate(dice);
    std::size_t best_gain = gain(best);
    for (int i = 1; i < candidates_of_a_row; ++i) {
        std::vector<Choice> other = candidate(dice);
        const std::size_t other_gain = gain(other);
        if (other_gain > best_gain) best = std::move(other), best_gain = other_gain;
    }
    Row row(levels_.size());
    for (const Choice& each : best) row[each.factor] = levels_[each.factor][each.level];
    return row;
}

void Covering::cover(const Row& row) {
    std::vector<Choice> choices;
    for (std::size_t factor = 0; factor < row.size(); ++factor) {
        const auto found = std::ranges::find(levels_[factor], row[factor]);
        if (found == levels_[factor].end()) return;  // of another law
        choices.push_back({factor, static_cast<std::size_t>(found - levels_[factor].begin())});
    }
    for (const Choice& a : choices)
        for (const Choice& b : choices) {
            if (a.factor >= b.factor || !fresh(a, b)) continue;
            seen_[cell(a, b)] = seen_[cell(b, a)] = true;
            ++covered_;
        }
}

}  // namespace candelabra::proof
