// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/diagnostics_json.h"

#include "text/printable.h"

#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson place(Span span, const SourceStore& sources) {
    if (!span.known() || span.source >= sources.count()) return nullptr;
    const Place from = sources.place(span.source, span.first);
    const Place to = sources.place(span.source, span.last);
    return {{"file", printable(sources.name(span.source))},
            {"line", from.line},
            {"column", from.column},
            {"end_line", to.line},
            {"end_column", to.column},
            {"first", span.first},
            {"last", span.last}};
}

std::string_view kind_of(const Frame& frame) {
    switch (frame.kind) {
        case Frame::macro:
            return "macro";
        case Frame::include:
            return "include";
        case Frame::loop:
            break;
    }
    return "loop";
}

std::string_view severity(const Diagnostic& diagnostic) {
    switch (diagnostic.severity) {
        case Severity::error:
            return "error";
        case Severity::warning:
            return "warning";
        case Severity::note:
            break;
    }
    return "note";
}

/// Serialises an object. Invalid UTF-8 becomes replacement characters rather than an exception.
std::string line(const OrderedJson& json) {
    return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

}  // namespace

std::string to_json(const Diagnostic& diagnostic, const SourceStore& sources) {
    OrderedJson json = {{"severity", severity(diagnostic)},
                        {"name", name(diagnostic.fault)},
                        {"message", diagnostic.message},
                        {"place", place(diagnostic.span, sources)},
                        {"label", diagnostic.label}};
    OrderedJson labels = OrderedJson::array(), frames = OrderedJson::array();
    for (const Label& label : diagnostic.labels)
        labels.push_back({{"place", place(label.span, sources)}, {"text", label.text}});
    for (const Frame& frame : diagnostic.frames)
        frames.push_back({{"kind", kind_of(frame)},
                          {"name", frame.name},
                          {"called_at", place(frame.called_at, sources)}});
    json["labels"] = std::move(labels);
    json["notes"] = diagnostic.notes;
    json["help"] = diagnostic.help;
    json["frames"] = std::move(frames);
    return line(json);
}

std::string debug_to_json(std::string_view text) {
    return line({{"severity", "debug"}, {"message", text}});
}

}  // namespace candelabra
