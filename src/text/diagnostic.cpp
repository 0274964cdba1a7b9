// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/diagnostic.h"

#include "text/message.h"

#include <array>
#include <utility>

namespace candelabra {

namespace {

constexpr auto infos = std::array{
    FaultInfo{Fault::syntax, "syntax", "a sign that means nothing where it stands"},
    FaultInfo{Fault::unterminated, "unterminated"},
    FaultInfo{Fault::unknown_character, "unknown-character"},
    FaultInfo{Fault::unknown_word, "unknown-word"},
    FaultInfo{Fault::unknown_name, "unknown-name", "an #undef of what is not declared"},
    FaultInfo{Fault::wrong_type, "wrong-type", "a cell that makes a column of numbers text"},
    FaultInfo{Fault::wrong_count, "wrong-count", "values that are left over or missing"},
    FaultInfo{Fault::out_of_range, "out-of-range"},
    FaultInfo{Fault::duplicate, "duplicate", "something given twice, of which the last counts"},
    FaultInfo{Fault::missing, "missing"},
    FaultInfo{Fault::misplaced, "misplaced"},
    FaultInfo{Fault::semicolon, "semicolon", "a `;` too many or too few"},
    FaultInfo{Fault::redefinition, "redefinition"},
    FaultInfo{Fault::uninitialised, "uninitialised"},
    FaultInfo{Fault::bad_index, "bad-index"},
    FaultInfo{Fault::domain, "domain", "an argument that a function is not defined for"},
    FaultInfo{Fault::division_by_zero, "division-by-zero",
              "a division by zero, which gives infinity"},
    FaultInfo{Fault::degenerate, "degenerate",
              "a shape without extent, or a vector without direction"},
    FaultInfo{Fault::recursion_limit, "recursion-limit"},
    FaultInfo{Fault::loop_limit, "loop-limit"},
    FaultInfo{Fault::include_not_found, "include-not-found"},
    FaultInfo{Fault::file_access, "file-access",
              "a file or a folder that a scene may not use, and is made without"},
    FaultInfo{Fault::io, "io"},
    FaultInfo{Fault::option, "option", "an option of the command line that has no effect"},
    FaultInfo{Fault::deprecated, "deprecated",
              "old ways of writing, and names that are declared as deprecated"},
    FaultInfo{Fault::not_implemented, "not-implemented"},
    FaultInfo{Fault::unused_parameter, "unused-parameter",
              "a parameter that its macro does not use"},
    FaultInfo{Fault::no_effect, "no-effect", "a value that is accepted but changes nothing"},
    FaultInfo{Fault::no_camera, "no-camera",
              "a scene without a camera, which gets the default one"},
    FaultInfo{Fault::no_object, "no-object", "a scene without an object"},
    FaultInfo{Fault::no_light, "no-light", "a scene that nothing lights"},
    FaultInfo{Fault::camera_inside, "camera-inside",
              "a camera inside an object that keeps out fog or all light"},
    FaultInfo{Fault::glowing_dome, "glowing-dome",
              "an object around the camera whose emission lights the scene"},
    FaultInfo{Fault::aspect, "aspect",
              "a picture of another shape than what the camera sees, which is stretched"},
    FaultInfo{Fault::lookalike, "lookalike",
              "a name of the library that is only alike to POV-Ray's, which is installed"},
    FaultInfo{Fault::user_error, "user-error"},
    FaultInfo{Fault::user_warning, "user-warning", "messages of the scene itself by #warning"},
};

constexpr bool in_order() {
    for (std::size_t i = 0; i < infos.size(); ++i)
        if (static_cast<std::size_t>(infos[i].fault) != i) return false;
    return static_cast<std::size_t>(Fault::user_warning) + 1 == infos.size();
}
static_assert(in_order());

}  // namespace

std::span<const FaultInfo> all_faults() { return infos; }

std::string_view name(Fault fault) { return infos[static_cast<std::size_t>(fault)].name; }

Diagnostic& Diagnostic::with_label(std::string text) {
    label = std::move(text);
    return *this;
}

Diagnostic& Diagnostic::with_help(std::string text) {
    help = std::move(text);
    return *this;
}

Diagnostic& Diagnostic::with_note(std::string text) {
    notes.push_back(std::move(text));
    return *this;
}

Diagnostic& Diagnostic::pointing(Span where, std::string text) {
    labels.push_back({where, std::move(text)});
    return *this;
}

namespace {

Diagnostic make(Severity severity, Fault fault, Span span, std::string message) {
    Diagnostic made;
    made.severity = severity;
    made.fault = fault;
    made.span = span;
    made.message = std::move(message);
    return made;
}

}  // namespace

Diagnostic error(Fault fault, Span span, std::string message) {
    return make(Severity::error, fault, span, std::move(message));
}

Diagnostic warning(Fault fault, Span span, std::string message) {
    return make(Severity::warning, fault, span, std::move(message));
}

Diagnostic note(Fault fault, Span span, std::string message) {
    return make(Severity::note, fault, span, std::move(message));
}

std::size_t Diagnostics::KeyHash::operator()(const Key& key) const {
    std::size_t hash = std::hash<std::string>{}(key.message);
    for (const std::uint32_t part : {key.span.source, key.span.first, key.span.last}) {
        hash = hash * 1000003 + part;
    }
    return hash;
}

bool Diagnostics::among_first(Fault fault) {
    auto& [count, rest_at] = warnings_[static_cast<std::size_t>(fault)];
    if (++count <= max_warnings) return true;
    if (count == max_warnings + 1) {
        rest_at = all_.size();
        all_.push_back(warning(fault, {}, {})
                           .with_help(message("--warn no-", candelabra::name(fault),
                                              " switches all of them off")));
    }
    all_[rest_at].message = message("and ", count - max_warnings, " more of this kind");
    return false;
}

void Diagnostics::add(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::warning) {
        if (muted_[static_cast<std::size_t>(diagnostic.fault)]) return;
        if (warnings_are_errors_) diagnostic.severity = Severity::error;
    }
    const bool is_error = diagnostic.severity == Severity::error;
    if (is_error && full()) return;
    if (settle_) settle_(diagnostic);
    if (!seen_.insert({diagnostic.span, diagnostic.message}).second) return;
    last_ = {diagnostic.fault, diagnostic.span};
    if (is_error) ++errors_;
    if (diagnostic.severity == Severity::warning && !among_first(diagnostic.fault)) return;
    if (frames_ && diagnostic.frames.empty()) diagnostic.frames = frames_();
    all_.push_back(std::move(diagnostic));
}

void Diagnostics::add_all(const Diagnostics& other) {
    for (std::size_t i = 0; i < other.all_.size(); ++i) {
        const Diagnostic& each = other.all_[i];
        const auto& [count, rest_at] = other.warnings_[static_cast<std::size_t>(each.fault)];
        if (count <= max_warnings || rest_at != i) {
            add(each);
            continue;
        }
        if (muted_[static_cast<std::size_t>(each.fault)]) continue;
        for (std::size_t k = max_warnings; k < count; ++k) among_first(each.fault);
    }
}

}  // namespace candelabra
