// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Diagnostics of an input as data: severity, kind of fault, message, places, help. Every stage adds
// to a Diagnostics and continues where it can; only the application prints them (text/excerpt.h).
// Messages are kept in the order of their arrival, each only once.

#include "text/span.h"

#include <array>
#include <bitset>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace candelabra {

enum class Severity { note, warning, error };

/// The kinds of problem. A test checks that each one can be produced.
enum class Fault {
    syntax,
    unterminated,
    unknown_character,
    unknown_word,
    unknown_name,
    wrong_type,
    wrong_count,
    out_of_range,
    duplicate,
    missing,
    misplaced,
    semicolon,
    redefinition,
    uninitialised,
    bad_index,
    domain,
    division_by_zero,
    degenerate,
    recursion_limit,
    loop_limit,
    include_not_found,
    file_access,
    io,
    option,
    deprecated,
    not_implemented,
    unused_parameter,
    no_effect,
    no_camera,
    no_object,
    no_light,
    camera_inside,
    glowing_dome,
    aspect,
    lookalike,
    user_error,
    user_warning,
};

/// The name of a kind of problem for users, such as `division-by-zero`.
struct FaultInfo {
    Fault fault;
    std::string_view name;
    std::string_view warns_of = {};  ///< the subject of its warnings; empty: always an error
};

/// Returns all kinds, in the order of the enumerators.
std::span<const FaultInfo> all_faults();

std::string_view name(Fault fault);

/// A further place worth showing, and a text about it.
struct Label {
    Span span;
    std::string text;
};

/// One step on the path by which the evaluation reached the place of a diagnostic.
struct Frame {
    enum Kind { macro, include, loop };

    Kind kind = macro;
    std::string name;
    Span called_at;
};

struct Diagnostic {
    Severity severity = Severity::error;
    Fault fault = Fault::syntax;
    std::string message;
    Span span;
    std::string label;  ///< the text after the carets
    std::vector<Label> labels;
    std::vector<std::string> notes;
    std::string help;
    std::vector<Frame> frames;  ///< innermost first

    Diagnostic& with_label(std::string text);
    Diagnostic& with_help(std::string text);
    Diagnostic& with_note(std::string text);
    Diagnostic& pointing(Span where, std::string text);
};

Diagnostic error(Fault fault, Span span, std::string message);
Diagnostic warning(Fault fault, Span span, std::string message);
Diagnostic note(Fault fault, Span span, std::string message);

class Diagnostics {
public:
    using Frames = std::function<std::vector<Frame>()>;
    using Settle = std::function<void(Diagnostic&)>;

    static constexpr std::size_t max_errors = 20;
    static constexpr std::size_t max_warnings = 20;  ///< per kind

    /// Keeps the diagnostic unless the same message was given for the same span, it is a warning
    /// that is switched off, or it is an error and the collector is full. A diagnostic without
    /// frames gets those of the provider. Warnings of a kind beyond the twentieth are replaced by
    /// one that counts them.
    void add(Diagnostic diagnostic);
    /// Adds all diagnostics of another collector.
    void add_all(const Diagnostics& other);

    /// Sets whether warnings of a kind are kept. Initially all are.
    void set_warning(Fault fault, bool kept) { muted_[static_cast<std::size_t>(fault)] = !kept; }
    /// Makes subsequent warnings count as errors.
    void make_warnings_errors() { warnings_are_errors_ = true; }

    /// Returns an empty collector with the same settings.
    Diagnostics fresh() const {
        Diagnostics result;
        result.muted_ = muted_;
        result.warnings_are_errors_ = warnings_are_errors_;
        return result;
    }

    bool failed() const { return errors_ > 0; }
    std::size_t error_count() const { return errors_; }

    /// Whether there are so many errors that processing of the input should stop.
    bool full() const { return errors_ >= max_errors; }

    const std::vector<Diagnostic>& all() const { return all_; }
    /// Number of distinct diagnostics that were added, whether kept or only counted.
    std::size_t count() const { return seen_.size(); }
    /// Kind and place of the last of these. Precondition: count() > 0.
    std::pair<Fault, Span> last() const { return last_; }

    /// Sets two callbacks: `frames` returns the path to the place of a kept diagnostic, innermost
    /// frame first; `settle` may move a diagnostic to a better place before it is compared with
    /// others. The caller resets them, with {}, before the objects that they refer to are
    /// destroyed.
    void set_frames(Frames frames, Settle settle = {}) {
        frames_ = std::move(frames);
        settle_ = std::move(settle);
    }

private:
    struct Key {
        Span span;
        std::string message;

        friend bool operator==(const Key&, const Key&) = default;
    };
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };

    static constexpr std::size_t kinds = static_cast<std::size_t>(Fault::user_warning) + 1;

    /// The number of warnings of a kind, and the index of the one that counts those beyond the
    /// limit.
    struct Warnings {
        std::size_t count = 0, rest_at = 0;
    };

    /// Counts a warning; returns whether it is within the limit of its kind.
    bool among_first(Fault);

    std::vector<Diagnostic> all_;
    std::unordered_set<Key, KeyHash> seen_;
    std::pair<Fault, Span> last_;
    Frames frames_;
    Settle settle_;
    std::size_t errors_ = 0;
    std::array<Warnings, kinds> warnings_;
    std::bitset<kinds> muted_;
    bool warnings_are_errors_ = false;
};

}  // namespace candelabra
