// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/costs.h"

#include "interpret/context.h"
#include "text/message.h"

namespace candelabra {

void Costs::exceeded(Span span, std::string message, std::string help) {
    if (!context_.stopped()) {
        Diagnostic problem = error(Fault::loop_limit, span, std::move(message));
        context_.report(point_at_loop(problem).with_help(std::move(help)));
    }
    context_.stop();
}

bool Costs::overspent(Span span) {
    exceeded(span,
             message("this scene takes more than ", limits.work / 1'000'000,
                     " million steps before it is rendered, which is the limit"),
             "strings, arrays, functions and files take steps as well as loops; --limit-work, in "
             "millions, raises the limit");
    return false;
}

bool Costs::count_file(Span span) {
    constexpr std::uint64_t opening = 10'000;
    if (++opened_files_ <= limits.files) return spend(opening, span);
    exceeded(span,
             message("this scene includes or opens files more than ", limits.files,
                     " times, which is the limit"),
             "a file that others include often can keep what it declares: #ifndef; --limit-files "
             "raises the limit");
    return false;
}

bool Costs::count_said(std::size_t bytes, Span span) {
    // An empty text costs time, too.
    constexpr std::uint64_t least = 16;
    said_bytes_ += least + bytes;
    if (said_bytes_ <= limits.said_bytes) return spend(bytes, span);
    exceeded(span,
             message("this scene has printed more than ", limits.said_bytes,
                     " bytes, which is the limit"),
             "--limit-said, in megabytes, raises it");
    return false;
}

void Costs::count_written(std::size_t bytes, Span span) {
    written_bytes_ += bytes;
    if (written_bytes_ <= limits.written_bytes) return;
    exceeded(span,
             message("this scene has written more than ", limits.written_bytes,
                     " bytes, which is the limit"),
             "--limit-written, in megabytes, raises it");
}

bool Costs::may_be_long(std::size_t bytes, Span span) {
    if (bytes <= limits.text_bytes) return spend(bytes / 4, span);
    exceeded(span,
             message("this string has more than ", limits.text_bytes, " bytes, which is the limit"),
             "--limit-text, in megabytes, raises it");
    return false;
}

bool Costs::may_be_costly(const Formula& formula, Span span) {
    if (formula.cost() <= limits.function_steps) return true;
    exceeded(span,
             message("a call of this function can take more than ", limits.function_steps,
                     " steps, which is the limit"),
             "functions that call others twice grow fast: compute a part beforehand, or pass it as "
             "an argument; --limit-function raises the limit");
    return false;
}

bool Costs::may_have_parts(std::uint64_t parts, Span span) {
    if (parts <= limits.objects) return spend(4 * parts, span);
    exceeded(span,
             message("this object has more than ", limits.objects,
                     " parts, which is the limit of objects"),
             "objects of objects grow fast; --limit-objects raises the limit");
    return false;
}

bool Costs::too_many_steps(const Tree& tree, NodeId place) {
    constexpr std::uint64_t each = 20, asked_after = 4096;
    if (steps_ % asked_after == asked_after - 1 && ended && ended()) {
        context_.stop();
        return true;
    }
    if (++steps_ <= limits.steps) return !spend(each, tree.span(place));
    if (!context_.stopped())
        context_.report(
            error(Fault::loop_limit, tree.span(place),
                  message("this scene takes more than ", limits.steps,
                          " passes of loops and calls of macros, which is the limit"))
                .with_help("something in a loop must make its condition false, or #break; "
                           "--limit-steps raises the limit"));
    context_.stop();
    return true;
}

void Costs::count_object(Span span) {
    if (++objects_ <= limits.objects || context_.stopped()) return;
    exceeded(
        span,
        message("this scene makes more than ", limits.objects, " objects, which is the limit"),
        "something in a loop must make its condition false, or #break; --limit-objects raises the "
        "limit");
}

void Costs::count_placed(std::uint64_t parts, Span span) {
    placed_ += parts;
    if (placed_ <= limits.objects || context_.stopped()) return;
    context_.report(error(Fault::loop_limit, span,
                          message("with the parts of this object there are more than ",
                                  limits.objects, " objects in the scene, which is the limit"))
                        .with_help("unions of unions grow fast; --limit-objects raises the limit"));
    context_.stop();
}

Span OpenLoop::place() const {
    Span all = tree->span(first);
    for (NodeId id = (*tree)[first].next; id != no_node; id = (*tree)[id].next)
        all = join(all, tree->span(id));
    return all;
}

const OpenLoop* Costs::busiest_loop() const {
    const OpenLoop* busiest = nullptr;
    for (const OpenLoop& each : loops)
        if (!busiest || each.passes >= busiest->passes) busiest = &each;
    return busiest;
}

Diagnostic& Costs::point_at_loop(Diagnostic& problem) const {
    if (const OpenLoop* loop = busiest_loop())
        problem.pointing(loop->place(), message("in this loop, which has run ", loop->passes,
                                                loop->passes == 1 ? " time" : " times"));
    return problem;
}

}  // namespace candelabra
