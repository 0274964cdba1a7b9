// SPDX-License-Identifier: GPL-3.0-or-later
// What an evaluation costs, and the limits of it. Where a limit is passed, the evaluation reports
// it and stops. Internal to the evaluator.
#pragma once

#include "formula/formula.h"
#include "interpret/limits.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace candelabra {

struct Context;

/// A running loop.
struct OpenLoop {
    const Tree* tree;
    NodeId first;  ///< first node of its condition or range
    std::uint64_t passes = 0;

    Span place() const;
};

class Costs {
public:
    explicit Costs(Context& context) : context_(context) {}

    Limits limits;
    /// Returns true if nobody wants the result any more; asked now and then. May be empty.
    std::function<bool()> ended;
    /// The innermost last. They stay here if evaluation ends early: a report names one.
    std::vector<OpenLoop> loops;
    /// Done so far, in the unit of Limits::work. Who adds to it directly has it checked by the next
    /// spend().
    std::uint64_t work = 0;

    /// Counts work. If it is too much, reports, stops and returns false.
    bool spend(std::uint64_t amount, Span place) {
        work += amount;
        return work <= limits.work || overspent(place);
    }
    /// Whether more work has been counted than there may be.
    bool spent() const { return work > limits.work; }
    /// Reports that too much work has been counted, and stops. Returns false.
    bool overspent(Span);

    /// Counts one more pass of a loop or call of a macro. If it is one too many, reports, stops and
    /// returns true; the same, without a report, if evaluation has ended.
    bool too_many_steps(const Tree&, NodeId);
    /// Counts a file that is included or opened. Returns false if it is one too many.
    bool count_file(Span);
    /// Counts the bytes of a message. Returns false if they are too many.
    bool count_said(std::size_t bytes, Span);
    /// Counts bytes written to files. If they are too many, reports and stops.
    void count_written(std::size_t bytes, Span);
    /// Whether a string may be this long; if not, reports and stops. Counts the work of making it.
    bool may_be_long(std::size_t bytes, Span);
    /// Whether a function may cost this much; if not, reports and stops.
    bool may_be_costly(const Formula&, Span);
    /// Whether an object may have this many parts; if not, reports and stops.
    bool may_have_parts(std::uint64_t parts, Span);
    /// Counts one more object. If it is one too many, reports and stops.
    void count_object(Span);
    /// The same for the parts of an object that is placed in the scene.
    void count_placed(std::uint64_t parts, Span);

    /// The open loop with the most passes, the innermost of equals; null if none is open.
    const OpenLoop* busiest_loop() const;

private:
    void exceeded(Span, std::string message, std::string help);
    /// Points at the busiest loop, which may have caused the problem.
    Diagnostic& point_at_loop(Diagnostic&) const;

    Context& context_;
    std::uint64_t steps_ = 0;
    std::uint64_t objects_ = 0;
    std::uint64_t placed_ = 0;  ///< objects in the scene with all their parts
    std::uint64_t written_bytes_ = 0, said_bytes_ = 0, opened_files_ = 0;
};

}  // namespace candelabra
