// SPDX-License-Identifier: GPL-3.0-or-later
// Walks trees: expands directives, macros, loops and includes, computes expressions, and hands the
// elements that remain to their handlers (the binder's). It knows the language and no item of a
// scene. Evaluation takes place in the order of the text; a block is handed over
// unevaluated and its content is walked when the binder asks for it, so variables then have the
// values they have at that place.
#pragma once

#include "base/function_ref.h"
#include "formula/formula.h"
#include "interpret/functions.h"
#include "interpret/limits.h"
#include "interpret/scene_noise.h"
#include "interpret/value.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"
#include "text/loader.h"
#include "text/source.h"
#include "vocabulary/words.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace candelabra {

/// One element of a body, after all directives are gone.
struct Element {
    enum class Kind {
        value,   ///< numbers, a string, an array, or a declared part of a scene; `word` is its name
                 ///< when it was a lone name
        word,    ///< a word of the language, or a name that nothing has declared: switches, items,
                 ///< kinds
        block,   ///< `word { body }`
        entry,   ///< `[ body ]`
        braces,  ///< `{ body }`
        list,    ///< `< ... >` with six numbers or more: a matrix, coefficients
        joined,  ///< `+ body`: what a directive adds to the expression that it goes on with
    };

    Kind kind = Kind::word;
    NameId word = no_name;
    Value value = Absence::nothing;
    Body body;
    Body origin;  ///< the node that the element comes from; none: it was made of several
    std::span<const double> list;  ///< valid while the element is taken
    Span span;                     ///< of the whole element
    Span word_span;                ///< of the word of a block; otherwise the same as span
};

/// What the scene can know about its run.
struct RunFacts {
    double clock = 0;
    bool clock_given = false;
    int image_width = 320;
    int image_height = 240;
    // Of an animation; all 0 when there is none.
    int frame_number = 0;
    int initial_frame = 0;
    int final_frame = 0;
    double initial_clock = 0;
    double final_clock = 0;
    double clock_delta = 0;
    std::string header;             ///< file that is included before the scene; empty: none
    std::optional<double> version;  ///< until the scene says one
};

/// The binder's side: what becomes of the elements. All may walk and evaluate; they may be called
/// while others of them run.
struct ElementHandlers {
    /// An element of the scene itself.
    std::function<void(const Element&)> top;
    /// A block, or several in a row (layers of a texture), where a value is wanted: what #declare
    /// stores.
    std::function<Value(std::span<const Element>)> value;
    /// The pattern or pigment in `function { ... }`, as a function of a point. Null: reported.
    std::function<Handle<Formula>(const Element&)> function;
    /// `#default { ... }`: each element of its body.
    std::function<void(const Element&)> set_default;
    /// Whether the word is nothing without what follows in braces: for messages.
    std::function<bool(NameId)> takes_braces;
    /// `#debug` and its relatives that are not diagnostics; the text comes as it is, without a line
    /// end added.
    std::function<void(std::string_view)> print;
};

class Evaluator {
public:
    using Take = FunctionRef<void(const Element&)>;

    /// All arguments outlive the evaluator.
    Evaluator(SourceStore&, const Loader&, Names&, Diagnostics&, const RunFacts& = {});
    ~Evaluator();
    Evaluator(const Evaluator&) = delete;
    Evaluator& operator=(const Evaluator&) = delete;

    /// Set once, before run(): the handlers usually refer to the evaluator.
    void set_handlers(ElementHandlers);

    /// Before run(): functions beside those of values, and what answers about objects. Both outlive
    /// the evaluator.
    void add_functions(std::span<const FunctionInfo>, ObjectQueries&);

    /// Before run(); otherwise the default limits hold.
    void set_limits(const Limits&);
    const Limits& limits() const;

    /// A global name from outside: `Declare=Depth=5`.
    void declare(std::string_view name, Value);

    /// Parses and walks the main file, on a stack of its own that is deep enough for any recursion
    /// within the limits.
    void run(SourceId main);

    /// Calls `take` for each element, in order, after all directives are gone. Names that are not
    /// declared and reserved words come as words; a value that could not be computed has been
    /// reported and comes as a broken value.
    void walk(Body, Take);

    /// The numbers of an expression, when it can be computed without saying anything. False:
    /// nothing has happened, and walk() must do it.
    bool compute(Body, Numbers&);
    /// Several compute() together: unless all is kept in the end, nothing has happened.
    void begin_attempt();
    void end_attempt(bool keep);
    /// What the name stands for now, or null.
    const Value* find(NameId) const;

    /// The element as a value: a block becomes one by the handlers; a word that is no value is
    /// reported.
    Value value_of(const Element&);

    /// The value of `#version`.
    double version() const;
    /// Whether a string of the scene has other characters than those of ASCII, so far as it is
    /// read.
    bool has_foreign_strings() const;
    /// What assumed_gamma has said: colours by srgb are converted to it from here on.
    void set_working_gamma(double);
    /// Whether `#version` has occurred.
    bool version_given() const;
    /// Lives on in the functions that use it.
    const std::shared_ptr<SceneNoise>& noise() const;

    /// A file of data that the scene names; nothing after a report.
    std::optional<std::string> load_data(const std::string& name, Span);
    /// The same, and where it is.
    std::optional<Found> load_found(const std::string& name, Span);
    /// The same of a name without an ending, which may stand for one with one of these.
    std::optional<Found> find_data(const std::string& name, Span,
                                   std::span<const std::string_view> endings);

    /// Adds the frames that lead here.
    void report(Diagnostic);
    /// A report says what is wrong with the word at that node: of parentheses right behind it
    /// nothing more has to be said.
    void note_reported(const Body& word);
    /// After #error or too many errors nothing more is evaluated; walk() returns early.
    bool stopped() const;
    /// Evaluates nothing more: going on makes no sense.
    void stop();
    /// To be called for each object that the scene keeps, at its place. Stops with a report when
    /// there are more than the limits allow.
    void count_object(Span);
    /// The same for an object that is put into the scene, with all its parts: those of declared
    /// objects count each time.
    void count_placed(std::uint64_t parts, Span);
    /// To be called before all parts of an object are looked at; false when there are too many,
    /// which stops.
    bool may_have_parts(std::uint64_t parts, Span);
    /// To be called before work that takes long: `amount` in steps of some nanoseconds. False when
    /// it is too much, which stops.
    bool spend(std::uint64_t amount, Span);
    /// Asks a function of x and y at all pixels that it has, row by row, both from 0 to 1; `good`:
    /// it has an answer there. False when that is too much work.
    enum class Rows { from_bottom, from_top };
    bool sample(const Formula&, Rows, Span,
                FunctionRef<void(const FunctionResults&, bool good)> visit);

    /// The element of an array, or what is in it, at a path such as "lamps.0.radiance". Broken
    /// after a report, absent when it is not set.
    Value element_at(const Value& array, std::string_view path, Span);
    /// A colour in the values of displays, and its opacity, as a colour of the scene.
    Numbers display_colour(const std::array<double, 4>&) const;

    std::string_view spelling(NameId) const;
    SourceStore& sources();
    /// Finds files, those that this run has written among them.
    const Loader& loader() const;
    Names& names();
    Diagnostics& diagnostics();

    /// Names that are declared now, for "did you mean".
    std::vector<std::string_view> declared_names() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace candelabra
