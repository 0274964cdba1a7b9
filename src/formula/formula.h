// SPDX-License-Identifier: GPL-3.0-or-later
// A function of numbers: the value of `function { ... }`. Its body is a program, or C++ code for
// functions that the language cannot express (a spline, a transformation, an internal function).
// Formulas are pure, and then safe to call from many threads, unless C++ code states otherwise.
#pragma once

#include "formula/enclosure.h"
#include "formula/program.h"

#include <array>
#include <memory>
#include <span>
#include <utility>

namespace candelabra {

/// Only as many elements are used as the function has results.
using FunctionResults = std::array<double, Program::max_results>;

class Formula {
public:
    /// Maximum nesting depth of calls between formulas; each level takes stack space.
    static constexpr int max_depth = 100;

    explicit Formula(Program program);
    /// Wraps C++ code: bool(const double* arguments, double* results). The results may overlap the
    /// arguments. The code returns false if it has no answer; the calling program then fails.
    template <class Code>
    Formula(std::size_t parameters, std::size_t results, Code code)
        : parameters_(parameters),
          results_(results),
          code_(std::make_shared<const Code>(std::move(code))),
          run_([](const void* code, const double* arguments, double* results,
                  std::uint32_t&) -> bool {
              return (*static_cast<const Code*>(code))(arguments, results);
          }) {}

    std::size_t parameters() const { return parameters_; }
    /// Number of results, 1 to 5.
    std::size_t results() const { return results_; }
    /// Maximum depth of nested formula calls, including this one.
    int depth() const { return depth_; }
    /// Number of steps of a call in which no loop repeats. An upper bound, except that C++ code
    /// counts as a few steps.
    std::uint64_t cost() const { return cost_; }

    /// Size in pixels of the picture that the function stands for; 0 if it stands for none.
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    /// Sets the size of the picture that the function stands for.
    void stand_for(int columns, int rows) {
        columns_ = columns;
        rows_ = rows;
    }

    bool run(const double* arguments, double* results) const {
        std::uint32_t passes = 0;
        return run_(code_.get(), arguments, results, passes);
    }
    /// Also adds the passes of all loops to `passes`.
    bool run(const double* arguments, double* results, std::uint32_t& passes) const {
        return run_(code_.get(), arguments, results, passes);
    }

    /// Whether the body is a program, and so are the bodies of all formulas that it calls.
    bool written() const { return written_; }
    /// Computes bounds of the results; see enclose(). Returns false if no bounds are known.
    bool enclose(const Enclosure* arguments, Enclosure* results) const;

    /// Returns the first result; NaN if there is none. Precondition: enough arguments.
    double value(std::span<const double> arguments) const;

private:
    std::size_t parameters_;
    std::size_t results_;
    int depth_ = 1;
    std::uint64_t cost_ = 10;
    bool written_ = false;
    int columns_ = 0, rows_ = 0;
    std::shared_ptr<const void> code_;  ///< a Program, or the code that a constructor was given
    bool (*run_)(const void* code, const double* arguments, double* results, std::uint32_t& passes);
};

}  // namespace candelabra
