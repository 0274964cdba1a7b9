// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of costs that do not show in the number of loops and calls: files, messages, long strings,
// functions of functions, objects of objects, and work of any kind.
#include "interpret/state.h"
#include "text/message.h"

namespace candelabra {

void Evaluator::State::exceeded(Span span, std::string message, std::string help) {
    if (!stopped_) {
        Diagnostic problem = error(Fault::loop_limit, span, std::move(message));
        report(point_at_loop(problem).with_help(std::move(help)));
    }
    stopped_ = true;
}

bool Evaluator::State::overspent(Span span) {
    exceeded(span,
             message("this scene takes more than ", limits.work / 1'000'000,
                     " million steps before it is rendered, which is the limit"),
             "strings, arrays, functions and files take steps as well as loops; --limit-work, in "
             "millions, raises the limit");
    return false;
}

bool Evaluator::State::count_file(Span span) {
    constexpr std::uint64_t opening = 10'000;
    if (++opened_files <= limits.files) return spend(opening, span);
    exceeded(span,
             message("this scene includes or opens files more than ", limits.files,
                     " times, which is the limit"),
             "a file that others include often can keep what it declares: #ifndef; --limit-files "
             "raises the limit");
    return false;
}

bool Evaluator::State::count_said(std::size_t bytes, Span span) {
    // An empty text costs time, too.
    constexpr std::uint64_t least = 16;
    said_bytes += least + bytes;
    if (said_bytes <= limits.said_bytes) return spend(bytes, span);
    exceeded(span,
             message("this scene has printed more than ", limits.said_bytes,
                     " bytes, which is the limit"),
             "--limit-said, in megabytes, raises it");
    return false;
}

bool Evaluator::State::may_be_long(std::size_t bytes, Span span) {
    if (bytes <= limits.text_bytes) return spend(bytes / 4, span);
    exceeded(span,
             message("this string has more than ", limits.text_bytes, " bytes, which is the limit"),
             "--limit-text, in megabytes, raises it");
    return false;
}

bool Evaluator::State::may_be_costly(const Formula& formula, Span span) {
    if (formula.cost() <= limits.function_steps) return true;
    exceeded(span,
             message("a call of this function can take more than ", limits.function_steps,
                     " steps, which is the limit"),
             "functions that call others twice grow fast: compute a part beforehand, or pass it as "
             "an argument; --limit-function raises the limit");
    return false;
}

bool Evaluator::State::may_have_parts(std::uint64_t parts, Span span) {
    if (parts <= limits.objects) return spend(4 * parts, span);
    exceeded(span,
             message("this object has more than ", limits.objects,
                     " parts, which is the limit of objects"),
             "objects of objects grow fast; --limit-objects raises the limit");
    return false;
}

}  // namespace candelabra
