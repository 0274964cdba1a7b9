// SPDX-License-Identifier: GPL-3.0-or-later
// A function of numbers: what `function { ... }` stands for. Its body is a program, or code of C++
// for what the language cannot write (a spline, a transformation, an internal function). Pure but
// for code that says otherwise, and then safe to call from many threads.
#pragma once

#include "formula/enclosure.h"
#include "formula/program.h"

#include <array>
#include <memory>
#include <span>
#include <utility>

namespace candelabra {

/// Of which as many count as a function has results.
using FunctionResults = std::array<double, Program::max_results>;

class Formula {
public:
    /// Formulas that call formulas, at most so deep: each level takes room on the stack.
    static constexpr int max_depth = 100;

    explicit Formula(Program program);
    /// Code of C++: bool(const double* arguments, double* results). The results may lie where the
    /// arguments do. It gives false when there is no answer; the program that called then gives up.
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
    /// 1 to 5.
    std::size_t results() const { return results_; }
    /// How many calls of formulas can be inside each other in it, itself included.
    int depth() const { return depth_; }
    /// How many steps a call takes when no loop in it repeats: an upper bound but for code of C++,
    /// which counts as few.
    std::uint64_t cost() const { return cost_; }

    /// Of a function that stands for a picture; otherwise 0.
    int columns() const { return columns_; }
    int rows() const { return rows_; }
    /// Pixels of the picture that it stands for.
    void stand_for(int columns, int rows) {
        columns_ = columns;
        rows_ = rows;
    }

    bool run(const double* arguments, double* results) const {
        std::uint32_t passes = 0;
        return run_(code_.get(), arguments, results, passes);
    }
    /// The same; passes of loops are added up.
    bool run(const double* arguments, double* results, std::uint32_t& passes) const {
        return run_(code_.get(), arguments, results, passes);
    }

    /// Whether it is a program, and so is all that it calls.
    bool written() const { return written_; }
    /// Between which numbers the results lie; see enclose(). False: nothing is known.
    bool enclose(const Enclosure* arguments, Enclosure* results) const;

    /// The first result; not a number when there is none. Precondition: enough arguments.
    double value(std::span<const double> arguments) const;

private:
    std::size_t parameters_;
    std::size_t results_;
    int depth_ = 1;
    std::uint64_t cost_ = 10;
    bool written_ = false;
    int columns_ = 0, rows_ = 0;
    std::shared_ptr<const void> code_;  ///< a Program, or what a constructor was given
    bool (*run_)(const void* code, const double* arguments, double* results, std::uint32_t& passes);
};

}  // namespace candelabra
