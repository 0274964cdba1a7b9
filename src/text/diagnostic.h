// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What there is to say about an input, as data: severity, kind of fault, message, places, help.
// Every stage is handed a Diagnostics to add to and goes on where it can; only the application
// prints (text/excerpt.h). Messages are kept in the order in which they came, each only once.

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
    user_error,
    user_warning,
};

/// A kind of problem as people know it: `division-by-zero`.
struct FaultInfo {
    Fault fault;
    std::string_view name;
    std::string_view warns_of = {};  ///< empty: always an error
};

/// All of them, in the order of the enumerators.
std::span<const FaultInfo> all_faults();

std::string_view name(Fault fault);

/// A second place worth showing, and what is there.
struct Label {
    Span span;
    std::string text;
};

/// One step of how the evaluation came to the place of a diagnostic.
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
    std::string label;  ///< the text behind the carets
    std::vector<Label> labels;
    std::vector<std::string> notes;
    std::string help;
    std::vector<Frame> frames;  ///< the innermost first

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
    static constexpr std::size_t max_warnings = 20;  ///< of a kind

    /// Keeps the diagnostic unless the same message was given for the same span, or it is a warning
    /// that is switched off, or an error and the collector is full. One without frames gets those
    /// of the provider. Of warnings of a kind beyond the twentieth one tells how many there are.
    void add(Diagnostic diagnostic);
    /// Adds all that another one has.
    void add_all(const Diagnostics& other);

    /// Whether warnings of a kind are kept; at first all are.
    void set_warning(Fault fault, bool kept) { muted_[static_cast<std::size_t>(fault)] = !kept; }
    /// From now on warnings count as errors.
    void make_warnings_errors() { warnings_are_errors_ = true; }

    /// An empty collector with the same settings.
    Diagnostics fresh() const {
        Diagnostics result;
        result.muted_ = muted_;
        result.warnings_are_errors_ = warnings_are_errors_;
        return result;
    }

    bool failed() const { return errors_ > 0; }
    std::size_t error_count() const { return errors_; }

    /// So many errors that whoever works on the input should stop.
    bool full() const { return errors_ >= max_errors; }

    const std::vector<Diagnostic>& all() const { return all_; }
    /// How many were new, whether they were kept or only counted.
    std::size_t count() const { return seen_.size(); }
    /// The kind and the place of the last of these. Precondition: count() > 0.
    std::pair<Fault, Span> last() const { return last_; }

    /// Called for each kept diagnostic to learn how its place was reached, innermost first; and to
    /// point it, before it is compared with others, at a better place. Whoever sets them takes them
    /// away again, with {}, before what they look at goes out of life.
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

    /// Warnings of a kind, and where it is told how many were too many.
    struct Warnings {
        std::size_t count = 0, rest_at = 0;
    };

    /// Whether a warning is one of the first of its kind; counts it in any case.
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
