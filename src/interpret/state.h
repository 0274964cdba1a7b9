// SPDX-License-Identifier: GPL-3.0-or-later
// The evaluator's internal state, which its parts (expression.cpp, array.cpp, call.cpp,
// directive.cpp) share. No other module includes it.
#pragma once

#include "interpret/array_data.h"
#include "interpret/code.h"
#include "interpret/evaluator.h"
#include "interpret/file_trees.h"
#include "interpret/files.h"
#include "interpret/frames.h"
#include "interpret/functions.h"
#include "interpret/indices.h"
#include "interpret/macro.h"
#include "interpret/scope.h"
#include "interpret/sink.h"

#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

namespace candelabra {

/// How a list of elements was left.
enum class Flow {
    end,     ///< at its end
    broken,  ///< by #break
    stopped  ///< nothing more is evaluated
};

/// A running loop.
struct OpenLoop {
    const Tree* tree;
    NodeId first;  ///< first node of its condition or range
    std::uint64_t passes = 0;

    Span place() const;
};

/// The component of numbers that a member names (`.x`), grey_component, or -1 for none.
int component_of(std::string_view member);
inline constexpr int grey_component = 5;
inline constexpr auto grey_weights = std::array{0.297, 0.589, 0.114};

struct Evaluator::State {
    State(Evaluator&, SourceStore&, const Loader&, Names&, Diagnostics&, const RunFacts&);

    // ---- evaluator.cpp
    void add_functions(std::span<const FunctionInfo>);
    void run(SourceId main);
    void learn(const Tree&);
    /// run(), with a report if memory runs out.
    void run_within_memory(SourceId main);
    /// Whether there is stack left to recurse further. Reports if there is not.
    bool room(const Tree& tree, NodeId id) {
        const char here = 0;
        return !stack_end || &here > stack_end || no_room(tree, id);
    }
    bool no_room(const Tree&, NodeId);
    /// Reports, and stops evaluation once the limit of errors is reached.
    void report(Diagnostic diagnostic) {
        diagnostics.add(std::move(diagnostic));
        if (diagnostics.full()) stopped_ = true;
    }
    /// Errors in the library are reported where the scene calls it.
    void point_at_scene(Diagnostic&) const;
    bool in_library(Span) const;
    Span outside_library(Span) const;
    std::string data_folder(Span) const;
    Value broken(Fault, Span, std::string message);
    bool stopped() const { return stopped_; }
    Value unknown_name(NameId, Span);
    std::pair<const Tree*, NodeId> own_declaration(NameId, Span use) const;
    /// The span from the word of a declaration, which may be long, to the name that it declares.
    Span heading(const Tree&, NodeId declaration, NameId) const;
    /// To be called where a name is used: warns if it is deprecated.
    void note_use(NameId name, const Tree& tree, NodeId id) {
        if (!deprecated.empty()) warn_deprecated(name, tree.span(id));
    }
    void warn_deprecated(NameId, Span);
    /// The value of some elements, of which one value is expected.
    Value one_value(std::span<const Element>, Span);
    Value one_value(OneValue&&, Span);
    /// Reports that a macro yields no value, or several, where one is expected.
    Value report_count(std::size_t, Span);
    /// An element `{ ... }`.
    static Element braces_element(const Tree&, NodeId);
    /// A block element as it is passed to the handlers.
    Element block_element(const Tree&, NodeId);

    // ---- compute.cpp: the fast path for numbers
    struct Compiler;  ///< compiler.h
    /// Computes the numbers of an expression if nothing has to be reported. Otherwise returns
    /// false, without effects, and walk_expression() must do it.
    bool compute(const Tree&, NodeId, Numbers&);
    std::optional<double> compute_scalar(const Tree&, NodeId);
    Code* compile(const Tree&, NodeId);
    bool load(Code&) const;
    bool run(Code&, Numbers& result);

    // ---- expression.cpp
    Value evaluate(const Tree&, NodeId);
    /// evaluate() without an attempt to compute() first.
    Value walk_expression(const Tree&, NodeId);
    /// Report values with commas between where one is wanted. The value is broken.
    Value refuse_tuple(const Tree&, NodeId);
    /// Moves the values in parentheses to where a declaration waits for them.
    Value take_tuple(const Tree&, NodeId);
    Value refuse_gap(const Tree&, NodeId);
    /// The value of the name, or null. A constant of newer versions counts where the scene declares
    /// no such name.
    const Value* value_named(NameId name) const {
        const Value* const found = scope.find(name);
        return found || name != tau ? found : &value_of_tau;
    }
    Value name_value(NameId, Span);
    Value index_value(const Tree&, const node::Index&, NodeId);
    /// The number of an expression; nothing after a report. `what` and the word begin the message:
    /// "the argument of `sin`".
    std::optional<double> number(const Tree&, NodeId, std::string_view what, NameId word = no_name);
    /// The number of an expression that nearly always is one. If nothing, its value is `other`,
    /// which number_in() converts to a number or reports.
    std::optional<double> number_or(const Tree&, NodeId, Value& other);
    std::optional<double> number_in(const Value&, const Tree&, NodeId, std::string_view what,
                                    NameId word = no_name);
    Value unary(const Tree&, const node::Unary&, NodeId);
    Value with_sign(Operator, Value, Span);
    Value binary(const Tree&, const node::Binary&, NodeId);
    Value combine(Operator, Value left, Value right, Span right_span, Span whole);
    // ---- chain.cpp
    /// An unevaluated operand, and the operators before it. The sign of the first is add.
    struct Operand {
        Operator sign;
        bool negative;
        const Tree& tree;
        NodeId id;
        Span span;  ///< its place in the expression: the call, if it is of a macro
    };
    class OperandWalk;
    /// Walks the operands of an expression in order. Macros and directives among them are expanded
    /// as if their text stood there. Returns false after a report.
    bool walk_operands(const Tree&, NodeId, FunctionRef<void(const Operand&)> take);
    /// The value of an expression whose operands are walked in this way.
    Value open_expression(const Tree&, NodeId);
    /// The call of a macro; null for other nodes.
    const node::Call* macro_call(const Tree&, NodeId) const;
    Value choice(const Tree&, const node::Choice&);
    /// Draws the random numbers that an expression would have drawn.
    void draw(const Tree&, NodeId);
    /// The calls of rand() in an expression, in order, except those in macros.
    std::vector<NodeId> random_calls(const Tree&, NodeId) const;
    Value group(const Tree&, NodeId content, Span);
    Value vector(const Tree&, const node::Vector&, NodeId);
    Value vector_of(const std::vector<double>&, Span);
    bool components(const Tree&, NodeId first, std::vector<double>&);
    Value member(const Tree&, const node::Member&, NodeId);
    Value constant(NameId);
    Value prefixed(const Tree&, const node::Prefixed&, NodeId);
    Value colour(const Tree&, const node::Colour&, NodeId);
    bool set_channel(const Tree&, const node::Channel&, Numbers&);
    Value truth(const Value&, const Value&, Operator, Span);

    // ---- array.cpp
    Value array(const Tree&, const node::Array&, NodeId);
    bool fill(ArrayData&, std::size_t dimension, std::size_t& next, const Element& braces);
    bool fill_one(ArrayData&, std::size_t at, Value value, Span);
    bool refuse_in_array(const ArrayData&, const Element&);
    bool leave_out(ArrayData&, std::size_t dimension, std::size_t& next);
    /// Whether the element is a name that nothing is declared as.
    bool is_undeclared(const Element&) const;
    bool make_room(Value& array, const Indices&, std::size_t used, Span);
    /// Must be called before the array is looked up: an index may call a macro that changes it.
    bool indices(const Tree&, NodeId first, Indices& result);
    /// The element at the indices, through arrays of arrays. Uninitialised if it is not set, broken
    /// after a report.
    Value element(const Value& array, Indices&, Span);
    /// An element for writing.
    struct Place {
        ArrayData* array = nullptr;  ///< null after a report
        std::size_t element = 0;
    };
    Place edit_element(Value& array, Indices&, Span);
    /// The position of an element in its array, or nothing after a report. Moves `used` past the
    /// indices that it used.
    std::optional<std::size_t> place(const ArrayData&, Indices&, std::size_t& used, Span);
    /// One index, checked against the size of its dimension; nothing after a report.
    std::optional<int> index_in(const ArrayData&, std::size_t dimension, Indices&,
                                std::size_t used);
    void report_unknown_name(const IndexNames*, const std::string& name, Span);
    bool check_array(const Value&, Span);

    // ---- call.cpp
    Value call(const Tree&, const node::Call&, NodeId);
    Value call_function(const Tree&, const node::Call&, NodeId);
    void receive(const Tree&, NodeId first, int count, const Value&);
    bool defined(const Tree&, NodeId target);
    void walk_arguments(const Tree&, NodeId first, FunctionRef<void(Value, Span)> take);

    /// Whether the name, in a call, stands for a function or a spline, not for a macro.
    bool is_function(NameId) const;
    /// A call of a function or a spline; `name` is for messages.
    Value call_value(const Tree&, const Value& called, NameId name, NodeId first, Span);

    // ---- user_function.cpp
    struct FunctionCompiler;
    Value function(const Tree&, const node::Function&, NodeId);
    std::optional<std::vector<NameId>> parameters(const Tree&, const node::Function&, NodeId);
    bool take_size(const Tree&, const node::Function&, Formula&);
    Handle<Formula> written_function(const Tree&, const node::Function&, NodeId);
    Handle<Formula> named_function(const Tree&, const node::Function&, NodeId);
    bool may_give_block(const Tree&, NodeId first, int depth = 0) const;
    Handle<Formula> block_function(const Tree&, NodeId body, NodeId);
    Handle<Formula> function_of(const Element&);
    bool check_count(NameId function, std::size_t count, const Formula&, Span);
    Value call_formula(const Tree&, Handle<Formula>, NameId, NodeId first, Span);
    Value call_spline(const Tree&, Handle<Spline>, NameId, NodeId first, Span);

    // ---- texts.cpp
    /// Whether the node is a call that append_text() can build.
    bool builds_text(const Tree& tree, NodeId id) const {
        const auto* call = tree.get_if<node::Call>(id);
        return call && (call->name == concat || call->name == str) &&
               has_plain_arguments(tree, *call);
    }
    bool has_plain_arguments(const Tree&, const node::Call&) const;
    /// Appends the text of an argument of the function. Returns false after a report.
    bool append_text(const Tree&, NodeId, std::string& text, NameId function);
    bool append_texts(const Tree&, NodeId first, std::string& text, NameId function);
    bool append_number(const Tree&, NodeId first, std::string& text);
    /// The number of an argument of a function; nothing after a report.
    std::optional<double> number_argument(const Tree&, NodeId, NameId function);

    // ---- macro.cpp
    void define_macro(const Tree&, const node::Macro&, NodeId);
    /// Opens a call: its parameters are bound until leave_macro(). Returns null, with nothing to
    /// leave, after a report.
    const MacroData* enter_macro(const Tree&, const node::Call&, NodeId);
    void leave_macro();
    /// Runs a macro; its elements go to `take`.
    Flow call_macro(const Tree&, const node::Call&, NodeId, const Sink& take);
    /// The macro that is called, or null after a report.
    const MacroData* called_macro(const Tree&, const node::Call&, NodeId);
    struct Argument {
        Scope::Reference place;
        bool by_value = false;  ///< the cell is a fresh one
        bool omitted = false;   ///< the parameter stays undeclared
        Span given;             ///< where it stands in the call
    };
    /// Puts a value into a cell of its own. Returns false if the value is broken.
    template <class Given>
    bool by_value(Given&& value, Argument& result) {
        result.by_value = true;
        result.place.cell = scope.fresh_cell();
        *result.place.cell = std::forward<Given>(value);
        return !result.place.cell->broken();
    }
    bool pass_values(const Tree&, const node::Call& inner, NodeId);
    /// Computes the arguments and appends them to `arguments`. Returns false after a report.
    bool pass_arguments(const Tree&, const node::Call&, NodeId, const MacroData&);
    /// Whether the arguments from `base` on, bound to the parameters of the macro that is being
    /// entered, are what these accept. Each that is not is reported.
    bool keeps_contracts(const MacroData&, std::size_t base);
    /// The bounds of a parameter as numbers. Nothing after a report, or if a bound is an argument
    /// that was refused (then not all are `kept`).
    std::optional<std::vector<MacroContract::Limit>> limits_of(const MacroData::Parameter&,
                                                               const Tree&, bool kept);
    void report_arguments(const MacroData&, std::size_t count, const Tree&, NodeId call);
    bool gives_nothing(const Tree&, NodeId);
    bool pass_argument(const Tree&, NodeId, const MacroData&, std::size_t place, Argument&);
    bool argument(const Tree&, NodeId, Argument&);
    bool argument_element(const Tree&, const node::Index&, NodeId, Argument&);

    // ---- walk.cpp, directive.cpp, declare.cpp
    Flow walk(const Tree&, NodeId first, const Sink& take);
    Flow walk_from(const Tree&, NodeId& id, const Sink& take);
    /// Walks a list that #break cannot leave: a file, the content of a block.
    void walk_whole(const Tree&, NodeId first, const Sink& take);
    /// Walks one node of a list.
    Flow walk_one(const Tree&, NodeId, const Sink& take);
    static bool is_directive(const Tree&, NodeId);
    Flow directive(const Tree&, NodeId, const Sink& take);
    // ---- spending.cpp: costs other than loops and calls
    /// Counts work, in the unit of the limit. If it is too much, reports, stops and returns false.
    bool spend(std::uint64_t amount, Span place) {
        work += amount;
        return work <= limits.work || overspent(place);
    }
    bool overspent(Span);
    /// Counts a file that is included or opened. Returns false if it is one too many.
    bool count_file(Span);
    /// Counts the bytes of a message. Returns false if they are too many.
    bool count_said(std::size_t bytes, Span);
    /// Whether a string may be this long; if not, reports and stops. Counts the work of making it.
    bool may_be_long(std::size_t bytes, Span);
    /// Whether a function may cost this much; if not, reports and stops.
    bool may_be_costly(const Formula&, Span);
    /// Whether an object may have this many parts; if not, reports and stops.
    bool may_have_parts(std::uint64_t parts, Span);
    void exceeded(Span, std::string message, std::string help);
    /// Counts one more step. If it is one too many, reports, stops and returns true.
    bool too_many_steps(const Tree&, NodeId);
    /// The open loop with the most passes, the innermost of equals; null if none is open.
    const OpenLoop* busiest_loop() const;
    /// Points at the busiest loop, which may have caused the problem.
    Diagnostic& point_at_loop(Diagnostic&) const;
    /// Counts one more object. If it is one too many, reports and stops.
    void count_object(Span);
    void count_placed(std::uint64_t parts, Span);
    std::optional<std::array<double, 3>> for_range(const Tree&, const node::For&, NodeId);
    std::optional<double> counter(NameId, Span);
    Flow branch(const Tree&, const node::If&, const Sink& take);
    /// The branch whose condition holds, or null.
    const node::Branch* taken_branch(const Tree&, const node::If&);
    Flow loop_while(const Tree&, const node::While&, const Sink& take);
    Flow loop_for(const Tree&, const node::For&, NodeId, const Sink& take);
    Flow choose(const Tree&, const node::Switch&, const Sink& take);
    bool condition(const Tree&, NodeId);
    void declare(const Tree&, const node::Declare&, NodeId);
    NodeId declare_layers(const Tree&, const node::Declare&, NodeId next);
    void declare_deprecated(const Tree&, const node::Deprecated&, NodeId);
    void declare_tuple(const Tree&, const node::Declare&, NodeId);
    void check_semicolon(const Tree& tree, const node::Declare& node) {
        if (!node.semicolon) report_semicolon(tree, node);
    }
    void report_semicolon(const Tree&, const node::Declare&);
    void declare_numbers(const Tree&, const node::Declare&, const Numbers&);
    void assign(const Tree&, NodeId target, Value&& value, bool local);
    void assign_element(const Tree&, const node::Index&, NodeId target, Value&& value);
    /// Declares a string built by concat() or str(), in place if possible. Returns false, with no
    /// effect, for other values.
    bool declare_text(const Tree&, const node::Declare&);
    Value right_side(const Tree&, NodeId);
    void undefine(const Tree&, NodeId target);
    Flow include(const Tree&, const node::Include&, NodeId, const Sink& take);
    const Tree* load(const std::string& name, Span);
    void speak(const Tree&, const node::Message&, NodeId);
    void set_version(const Tree&, const node::Version&, NodeId);
    void check_version(const Tree&, NodeId, double asked);

    // ---- files.cpp
    void open_file(const Tree&, const node::Open&, NodeId);
    void open_for_reading(DataFile&, Span);
    SourceId data_source(Found, Span);
    void open_for_writing(DataFile&, bool append, Span);
    std::unique_ptr<DataWriter> writer_for(const std::string& path, bool append);
    /// The open file of a name; null after a report.
    Handle<DataFile> open_file_named(const Tree&, NodeId);
    Handle<DataFile> open_file_named(NameId, Span);
    void close_file(const Tree&, const node::Close&, NodeId);
    void check_written(const std::shared_ptr<DataWriter>&, Span);
    /// Checks, at the end, the files that the scene did not close.
    void check_written_files();
    void read_values(const Tree&, const node::Read&, NodeId);
    bool read_into(const Tree&, NodeId target, DataReader&);
    void warn_of_line_end(const DataFile&, Span target, Span before);
    void write_values(const Tree&, const node::Write&, NodeId);
    void write_value(DataWriter&, const Value&, const std::optional<BinaryForm>&, Span);

    // ---- walk.cpp
    /// Passes the element of a value node to `take`, with the channels that follow it
    /// (`Red filter .5`). Returns the next node.
    NodeId take_value(const Tree&, NodeId, const Sink& take);
    Flow take_vector(const Tree&, NodeId, const Sink& take);
    NodeId take_power(const Tree&, NodeId, const Sink& take);

    Evaluator& evaluator;
    SourceStore& sources;
    Loader loader;  ///< knows the files that this run has written
    Names& names;
    Diagnostics& diagnostics;
    RunFacts facts;
    ElementHandlers handlers;
    Limits limits;
    Scope scope;
    Frames frames;
    FunctionWorld world;
    std::vector<const FunctionInfo*> functions;  ///< by name; null: none
    const NameId tau = names.intern("tau");
    const Value value_of_tau = 2 * std::numbers::pi;
    const NameId concat = names.find("concat");
    const NameId str = names.find("str");
    FileTrees files{sources, loader, names, diagnostics};
    CodeTable codes;
    std::map<std::pair<SourceId, NodeId>, MacroData> macros;  ///< by place of definition
    struct Deprecation {
        std::string text;
        bool once = false;
        std::set<std::pair<SourceId, std::uint32_t>> places;  ///< at which it has been reported
    };
    std::map<NameId, Deprecation> deprecated;
    std::vector<Argument> arguments;  ///< of the calls that are being made
    std::size_t include_depth = 0;
    /// The innermost last. They stay here if evaluation ends early: a report names one.
    std::vector<OpenLoop> loops;
    double working_gamma = 1;  ///< of colours, set by assumed_gamma
    LightUnits light_units;
    bool light_units_used = false;  ///< a function has converted an amount of light
    std::uint64_t steps = 0;
    std::uint64_t objects = 0;
    std::uint64_t placed = 0;                      ///< objects in the scene with all their parts
    std::vector<WrittenFile> written_files;        ///< that are still to be checked
    std::map<std::string, SourceId> data_sources;  ///< of #fopen, by path
    std::set<std::string> crossed_lines;  ///< files in which a #read continued in the next line
    std::uint64_t written_bytes = 0, said_bytes = 0, opened_files = 0;
    std::uint64_t work = 0;
    double version = 3.7;
    bool version_given = false;
    bool semicolons_reported = false;  ///< the rule of semicolons has been given
    std::shared_ptr<SceneNoise> noise = std::make_shared<SceneNoise>();
    Span last_break;
    Body reported;  ///< the last reported word
    bool stopped_ = false;
    /// Receives the values in parentheses that a macro gives to `#declare (a, b) = M();`. Null if
    /// none are expected.
    std::vector<Value>* awaited_tuple_ = nullptr;
    const char* stack_end = nullptr;  ///< lowest address that the stack may reach; null: unlimited
};

}  // namespace candelabra
