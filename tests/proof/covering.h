// SPDX-License-Identifier: GPL-3.0-or-later
// A covering array of strength two: rows that choose a level of each factor so that every pair of
// levels of two factors occurs in some row. Rows are made one at a time, each of which covers many
// pairs that no row has yet (Cohen, Dalal, Fredman, Patton, The AETG system, 1997).
#pragma once

#include "proof/dice.h"

#include <cstddef>
#include <vector>

namespace candelabra::proof {

/// The chosen level of each factor.
using Row = std::vector<std::size_t>;

class Covering {
public:
    /// The levels that each factor may take, by number; none of these lists is empty.
    explicit Covering(std::vector<std::vector<std::size_t>> levels);

    Row next(Dice&) const;
    /// Notes the pairs of a row as covered.
    void cover(const Row&);

    std::size_t pairs() const { return pairs_; }
    std::size_t covered() const { return covered_; }

private:
    struct Choice {
        std::size_t factor, level;  ///< the level by its place in the list of its factor
    };
    std::size_t cell(Choice a, Choice b) const;
    bool fresh(Choice a, Choice b) const { return !seen_[cell(a, b)]; }
    Choice any_fresh(Dice&) const;
    std::size_t gain(const std::vector<Choice>& row, Choice more) const;
    std::vector<Choice> candidate(Dice&) const;
    std::size_t gain(const std::vector<Choice>& row) const;

    std::vector<std::vector<std::size_t>> levels_;
    std::vector<std::size_t> first_;  ///< number of each factor's first level, counted through all
    std::size_t all_ = 0;             ///< levels of all factors
    std::vector<bool> seen_;          ///< pairs of levels, both ways round
    std::size_t pairs_ = 0, covered_ = 0;
};

}  // namespace candelabra::proof
