// SPDX-License-Identifier: GPL-3.0-or-later
// Which of the random numbers that start a light path lead to light that matters, as trials have
// found: the numbers are drawn mostly from there.
#pragma once

#include "base/vector.h"
#include "base/weighted_index.h"

#include <array>

namespace candelabra {

/// What paths that start in each cell of the unit square are worth.
class StartTrials {
public:
    static constexpr int across = 16, cells = across * across;

    /// A place in the cell of trial `number`: consecutive trials are in different cells.
    static Vec2 place(std::size_t number, const Vec2& in_cell) {
        const auto cell = static_cast<int>(number % cells);
        return {(cell % across + in_cell.x) / across, (cell / across + in_cell.y) / across};
    }
    void add(std::size_t number, double worth) { worth_[number % cells] += worth; }
    double sum() const;

private:
    friend class StartGuide;
    std::array<double, cells> worth_{};
};

class StartGuide {
public:
    StartGuide() = default;  ///< draws all places alike
    /// Half of the places are drawn by what the trials have found. Precondition: each cell had as
    /// many.
    explicit StartGuide(const StartTrials&);

    struct Drawn {
        Vec2 place;     ///< in [0, 1)^2
        double factor;  ///< 1 over the density of the place
    };
    Drawn draw(const Vec2& u) const;

private:
    WeightedIndex cells_;
};

}  // namespace candelabra
