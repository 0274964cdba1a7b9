// SPDX-License-Identifier: GPL-3.0-or-later
// Walks trees: expands directives, macros, loops and includes, computes expressions, and passes the
// remaining elements to the binder's handlers. It knows the language but no item of a scene.
// Evaluation follows the order of the text. A block is passed on unevaluated, and its content is
// walked when the binder asks for it, so variables have the values that they have at that place.
#pragma once

#include "base/function_ref.h"
#include "formula/formula.h"
#include "interpret/functions.h"
#include "interpret/limits.h"
#include "interpret/scene_noise.h"
#include "interpret/value.h"
#include "photometry/light_units.h"
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

/// The newest version of the language that `#version` may ask for.
inline constexpr double newest_version = 3.8;
/// The first with the defaults of today: no ambient light, white pigments, cameras as wide as the
/// picture.
inline constexpr double modern_version = 3.8;

/// One element of a body, after all directives have been carried out.
struct Element {
    enum class Kind {
        value,   ///< numbers, a string, an array, or a declared part of a scene; `word` is its name
                 ///< if it was a lone name
        word,    ///< a word of the language or an undeclared name: switches, items, kinds
        block,   ///< `word { body }`
        entry,   ///< `[ body ]`
        braces,  ///< `{ body }`
        list,    ///< `< ... >` with six numbers or more: a matrix, coefficients
        joined,  ///< `+ body`: the part that a directive adds to the expression before it
        omitted,  ///< nothing, where a comma shows that something is left out
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

/// Facts about the run that a scene can read.
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
    std::optional<double> version;  ///< until the scene sets one
};

/// The binder's handlers of elements. All may walk and evaluate, and may be called while others of
/// them run.
struct ElementHandlers {
    /// Takes an element of the scene itself.
    std::function<void(const Element&)> top;
    /// The value of a block, or of several in a row (layers of a texture), as #declare stores it.
    std::function<Value(std::span<const Element>)> value;
    /// The one value of two that a macro yields in a row as blocks: a texture over another.
    /// Absence::nothing if they remain two; a null handler: they always do.
    std::function<Value(const Value& below, const Value& above, Span)> layered;
    /// The pattern or pigment in `function { ... }`, as a function of a point. Null after a report.
    std::function<Handle<Formula>(const Element&)> function;
    /// Takes each element in the body of `#default { ... }`.
    std::function<void(const Element&)> set_default;
    /// Told of each version of the language that comes into force, first of the one at the start.
    /// The span is that of `#version`. May be null.
    std::function<void(double, Span)> set_version;
    /// Whether the word needs braces after it, for messages.
    std::function<bool(NameId)> takes_braces;
    /// Whether the name, which is not reserved, is a word of some block. In a block, parentheses
    /// behind it are those of its value: `along (A)*x`.
    std::function<bool(NameId)> knows_word;
    /// Prints the text of `#debug`, `#render` and `#statistics`, without an added line end.
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

    /// Adds functions beside those of values, and the object that answers queries about objects. To
    /// be called before run(). Both outlive the evaluator.
    void add_functions(std::span<const FunctionInfo>, ObjectQueries&);

    /// To be called before run(); otherwise the default limits hold.
    void set_limits(const Limits&);
    /// Sets a function that ends the evaluation, without a message, by returning true. It is asked
    /// after some thousand passes of loops and calls of macros. To be called before run().
    void set_ended(std::function<bool()>);
    const Limits& limits() const;

    /// Declares a global name from outside the scene: `Declare=Depth=5`.
    void declare(std::string_view name, Value);
    /// Makes a declared name undeclared.
    void undeclare(NameId);

    /// Parses and walks the main file, on a stack of its own that is deep enough for any recursion
    /// within the limits.
    void run(SourceId main);

    /// Carries out directives and calls `take` for each remaining element, in order. Undeclared
    /// names and reserved words are passed as words. A value that could not be computed has been
    /// reported and is passed as a broken value.
    void walk(Body, Take);

    /// Computes the numbers of an expression if nothing has to be reported. Otherwise returns
    /// false, without effects, and walk() must do it.
    bool compute(Body, Numbers&);
    /// Brackets several compute(): unless `keep` is true at the end, they have no effects.
    void begin_attempt();
    void end_attempt(bool keep);
    /// The current value of the name, or null.
    const Value* find(NameId) const;

    /// The element as a value. The handlers make the value of a block; a word that is not a value
    /// is reported.
    Value value_of(const Element&);

    /// The value of `#version`.
    double version() const;
    /// Whether a string in the files read so far has characters beyond ASCII.
    bool has_foreign_strings() const;
    /// Sets the gamma that assumed_gamma states. From here on srgb colours are converted to it.
    void set_working_gamma(double);
    double working_gamma() const;
    /// What amounts of light are in the scene's numbers. use_light_units() notes that a function
    /// has asked, after which set_light_units() returns false for other units and does nothing.
    const LightUnits& use_light_units();
    [[nodiscard]] bool set_light_units(const LightUnits&);
    /// Whether `#version` has occurred.
    bool version_given() const;
    const RunFacts& facts() const;
    /// Whether the span is in a file of the library.
    bool in_library(Span) const;
    /// The noise of the scene, which lives on in the functions that use it.
    const std::shared_ptr<SceneNoise>& noise() const;

    /// The text of a data file that the scene names; nothing after a report.
    std::optional<std::string> load_data(const std::string& name, Span);
    /// The same, with the path of the file.
    std::optional<Found> load_found(const std::string& name, Span);
    /// The same for a name without an ending, to which one of these may be added.
    std::optional<Found> find_data(const std::string& name, Span,
                                   std::span<const std::string_view> endings);

    /// Reports a diagnostic, with the frames that lead here.
    void report(Diagnostic);
    /// Notes that the word at that node has been reported: then parentheses directly after it need
    /// no report.
    void note_reported(const Body& word);
    /// Whether evaluation has stopped, as after #error or too many errors; walk() then returns
    /// early.
    bool stopped() const;
    /// Stops evaluation, where going on makes no sense.
    void stop();
    /// To be called for each object that the scene keeps, at its place. Stops with a report if
    /// there are more than the limits allow.
    void count_object(Span);
    /// The same for an object that is placed in the scene, with all its parts. Parts of declared
    /// objects count each time.
    void count_placed(std::uint64_t parts, Span);
    /// To be called before all parts of an object are visited. If there are too many, stops and
    /// returns false.
    bool may_have_parts(std::uint64_t parts, Span);
    /// To be called before long work. `amount`: steps of some nanoseconds each. If it is too much,
    /// stops and returns false.
    bool spend(std::uint64_t amount, Span);
    /// Evaluates a function of x and y, both from 0 to 1, at all its pixels, row by row. `good`:
    /// whether it has a value there. Returns false if that is too much work.
    enum class Rows { from_bottom, from_top };
    bool sample(const Formula&, Rows, Span,
                FunctionRef<void(const FunctionResults&, bool good)> visit);

    /// The element of an array, or of arrays in it, at a path such as "lamps.0.radiance". Broken
    /// after a report, absent if it is not set.
    Value element_at(const Value& array, std::string_view path, Span);
    /// Converts an sRGB colour and its opacity to a colour of the scene.
    Numbers display_colour(const std::array<double, 4>&) const;

    std::string_view spelling(NameId) const;
    SourceStore& sources();
    /// Finds files, including those that this run has written.
    const Loader& loader() const;
    Names& names();
    Diagnostics& diagnostics();

    /// Currently declared names, for "did you mean".
    std::vector<std::string_view> declared_names() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace candelabra
