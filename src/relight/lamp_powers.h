// SPDX-License-Identifier: GPL-3.0-or-later
// The powers of lamps with which meters read what they are to, with the least light. The light at a
// meter is a sum over lamps, so this is a linear programme. It is solved with the light of one half
// of the samples, and judged with that of the other, which the solution does not know.
#pragma once

#include "solver/linear_programme.h"
#include "text/diagnostic.h"

#include <array>
#include <cstddef>
#include <vector>

namespace candelabra {

/// What is asked of values at points: bounds of each, or of their mean.
struct LightDemand {
    std::size_t first = 0, count = 0;  ///< of the points
    double low = 0, high = LinearProgramme::unbounded;
    bool of_mean = false;
};

/// The light at points by one half of the samples.
struct LightAtPoints {
    std::vector<double> fixed;    ///< of each point, that no power changes
    std::vector<double> by_lamp;  ///< of each point and lamp, at the power that was rendered
};

struct PowerProblem {
    std::size_t lamps = 0;
    std::array<LightAtPoints, 2> halves;
    std::vector<double> costs;                 ///< of each lamp at the power that was rendered
    double most = LinearProgramme::unbounded;  ///< power of a lamp
    std::vector<LightDemand> demands;
};

/// One bound, of a point or of a mean.
struct SolvedBound {
    std::size_t demand = 0;
    std::size_t point = 0;  ///< the first one if it is that of a mean
    bool upper = false;
    double bound = 0;                    ///< that was asked for
    double solved = 0;                   ///< by the half of the samples that was solved
    double judged = 0;                   ///< by the other half
    bool tight = false, missed = false;  ///< what the solution just meets, and what none meets
};

struct SolvedPowers {
    std::vector<double> powers;  ///< in terms of those that were rendered; empty after an error
    /// Lamps that were left out, and are off, because their light is not known: over the points of
    /// the demands, a mean of the halves is less than twice its standard error.
    std::vector<std::size_t> unknown;
    double cost = 0;             ///< in terms of that of the rendered powers
    std::vector<SolvedBound> bounds;
    double gap = 0;   ///< greatest difference of a value between the halves, in terms of a bound
    bool met = true;  ///< whether all is met by the half that was solved
};

/// Solves it. What no powers meet is missed by as little as possible, in terms of its bound.
/// Reports an error, and returns no powers, if the solver is not there.
SolvedPowers solved(const PowerProblem&, Diagnostics&);

}  // namespace candelabra
