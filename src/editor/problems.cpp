// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/problems.h"

#include "text/message.h"

namespace candelabra {

namespace {

class Problems {
public:
    Problems(const Report& report, const Workspace& workspace, const std::string& scene)
        : sources_(report.sources), workspace_(workspace), scene_(scene) {
        found_[scene];
        for (const Diagnostic& each : report.diagnostics.all()) add(each);
    }

    std::map<std::string, std::vector<Json>> take() { return std::move(found_); }

private:
    bool known(Span span) const { return span.known() && span.source < sources_.count(); }

    bool is_open(Span span) const {
        return known(span) && workspace_.is_open(sources_.name(span.source));
    }

    /// Returns the span in an open file at which users see the diagnostic.
    Span shown_at(const Diagnostic& each) const {
        if (is_open(each.span)) return each.span;
        for (const Frame& frame : each.frames)
            if (is_open(frame.called_at)) return frame.called_at;
        return {};
    }

    Json range(Span span) const {
        if (!known(span)) return range_of("", {});
        return range_of(sources_.text(span.source), {span.first, span.last});
    }

    Json location(Span span) const {
        return {{"uri", uri_of(sources_.name(span.source))}, {"range", range(span)}};
    }

    Json related(const Diagnostic& each, Span shown) const {
        Json list = Json::array();
        const auto add = [&](Span span, const std::string& text) {
            if (known(span) && span != shown)
                list.push_back({{"location", location(span)}, {"message", text}});
        };
        add(each.span, each.message);
        for (const Label& label : each.labels) add(label.span, label.text);
        for (const Frame& frame : each.frames)
            add(frame.called_at, message("on the way to `", frame.name, "`"));
        return list;
    }

    void add(const Diagnostic& each) {
        std::string text = each.message;
        if (!each.label.empty()) text += message("\n", each.label);
        for (const std::string& note : each.notes) text += message("\n", note);
        if (!each.help.empty()) text += message("\nhelp: ", each.help);
        const Span shown = shown_at(each);
        const int severity = each.severity == Severity::error     ? 1
                             : each.severity == Severity::warning ? 2
                                                                  : 3;
        found_[known(shown) ? sources_.name(shown.source) : scene_].push_back(
            {{"range", range(shown)},
             {"severity", severity},
             {"code", std::string(name(each.fault))},
             {"source", "candelabra"},
             {"message", text},
             {"relatedInformation", related(each, shown)}});
    }

    const SourceStore& sources_;
    const Workspace& workspace_;
    const std::string& scene_;
    std::map<std::string, std::vector<Json>> found_;
};

}  // namespace

std::map<std::string, std::vector<Json>> problems(const Report& report, const Workspace& workspace,
                                                  const std::string& scene) {
    return Problems(report, workspace, scene).take();
}

}  // namespace candelabra
