// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/frames.h"

#include "interpret/state.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>

namespace candelabra {

bool Evaluator::State::in_library(Span span) const {
    return span.known() && loader.in_standard_library(sources.name(span.source));
}

/// Maps a place in the library to that of the scene's call that led there.
Span Evaluator::State::outside_library(Span span) const {
    if (!in_library(span)) return span;
    const std::vector<Frame> open = frames.list(names, sources);
    const auto call = std::ranges::find_if(open, [&](const Frame& frame) {
        return frame.called_at.known() && !in_library(frame.called_at);
    });
    return call == open.end() ? span : call->called_at;
}

void Evaluator::State::point_at_scene(Diagnostic& diagnostic) const {
    const Span inner = diagnostic.span, outer = outside_library(inner);
    if (outer == inner) return;
    const std::string& path = sources.name(inner.source);
    diagnostic.with_note(
        message("this comes from the library: ", printable(path.substr(path.rfind('/') + 1)), ":",
                sources.place(inner.source, inner.first).line));
    diagnostic.span = outer;
    diagnostic.label.clear();
    // Calls within the library say nothing to who calls it.
    diagnostic.frames = frames.list(names, sources);
    std::erase_if(diagnostic.frames,
                  [&](const Frame& frame) { return in_library(frame.called_at); });
}

}  // namespace candelabra
