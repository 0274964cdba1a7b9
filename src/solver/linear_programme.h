// SPDX-License-Identifier: GPL-3.0-or-later
// Linear programmes, solved by GLPK. The program opens this library when it needs it.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace candelabra {

/// Finds the x of least cost within bounds. All numbers are finite except upper bounds.
struct LinearProgramme {
    static constexpr double unbounded = std::numeric_limits<double>::infinity();

    /// low <= factors * x + slack * x[slack_column] <= high
    struct Row {
        std::vector<double> factors;  ///< of the first columns
        double low = -unbounded, high = unbounded;
        double slack = 0;  ///< factor of one further column; 0: none
        std::size_t slack_column = 0;
    };
    std::vector<double> costs;  ///< of each column
    std::vector<double> most;   ///< of each column, whose least value is 0
    std::vector<Row> rows;
};

struct Solver {
    /// Sets x and returns an empty string, or says why there is no solution.
    std::string (*minimise)(const LinearProgramme&, std::vector<double>& x);
};

/// The name of the library, and of its one function: `const Solver* candelabra_solver()`.
inline constexpr auto solver_library = "libcandelabra_solver.so";
inline constexpr auto solver_function = "candelabra_solver";

}  // namespace candelabra
