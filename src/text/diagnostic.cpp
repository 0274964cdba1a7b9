// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/diagnostic.h"

#include <utility>

std::string_view name(Fault fault) {
    switch (fault) {
        case Fault::syntax:
            return "syntax";
        case Fault::unterminated:
            return "unterminated";
        case Fault::unknown_character:
            return "unknown_character";
        case Fault::unknown_word:
            return "unknown_word";
        case Fault::unknown_name:
            return "unknown_name";
        case Fault::wrong_type:
            return "wrong_type";
        case Fault::wrong_count:
            return "wrong_count";
        case Fault::out_of_range:
            return "out_of_range";
        case Fault::duplicate:
            return "duplicate";
        case Fault::missing:
            return "missing";
        case Fault::misplaced:
            return "misplaced";
        case Fault::semicolon:
            return "semicolon";
        case Fault::redefinition:
            return "redefinition";
        case Fault::uninitialised:
            return "uninitialised";
        case Fault::bad_index:
            return "bad_index";
        case Fault::domain:
            return "domain";
        case Fault::division_by_zero:
            return "division_by_zero";
        case Fault::degenerate:
            return "degenerate";
        case Fault::recursion_limit:
            return "recursion_limit";
        case Fault::loop_limit:
            return "loop_limit";
        case Fault::include_not_found:
            return "include_not_found";
        case Fault::file_access:
            return "file_access";
        case Fault::io:
            return "io";
        case Fault::option:
            return "option";
        case Fault::deprecated:
            return "deprecated";
        case Fault::not_implemented:
            return "not_implemented";
        case Fault::user_error:
            return "user_error";
        case Fault::user_warning:
            return "user_warning";
    }
    return "";
}

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

void Diagnostics::add(Diagnostic diagnostic) {
    const bool is_error = diagnostic.severity == Severity::error;
    if (is_error && full()) return;
    if (!seen_.insert({diagnostic.span, diagnostic.message}).second) return;
    if (is_error) ++errors_;
    if (frames_ && diagnostic.frames.empty()) diagnostic.frames = frames_();
    all_.push_back(std::move(diagnostic));
}
