// SPDX-License-Identifier: GPL-3.0-or-later
// The inside of the evaluator: what its parts (expression.cpp, array.cpp, call.cpp, directive.cpp)
// share. Nobody else includes it.
#pragma once

#include "evaluate/evaluator.h"
#include "evaluate/files.h"
#include "evaluate/frames.h"
#include "evaluate/functions.h"
#include "evaluate/macro.h"
#include "evaluate/scope.h"

#include <deque>
#include <map>
#include <string>
#include <vector>

/// How a list of elements was left.
enum class Flow {
    end,     ///< at its end
    broken,  ///< by #break
    stopped  ///< nothing more is evaluated
};

/// `[i][j]`, computed.
struct Indices {
    std::array<double, 16> values;
    std::array<Span, 16> places;
    std::size_t count = 0;
};

struct Evaluator::State {
    State(Evaluator&, SourceStore&, const Loader&, Names&, Diagnostics&, const RunFacts&);

    // ---- evaluator.cpp
    void run(SourceId main);
    /// The same, with a message when memory runs out.
    void run_within_memory(SourceId main);
    /// Whether there is stack left to go deeper; reports when not.
    bool room(const Tree&, NodeId);
    void report(Diagnostic diagnostic) { diagnostics.add(std::move(diagnostic)); }
    Value broken(Fault, Span, std::string message);
    bool stopped() const { return stopped_; }
    Value unknown_name(NameId, Span);
    /// The one value of some elements, for a place where a value is wanted.
    Value one_value(std::span<const Element>, Span);
    /// A block element as it is handed to the meaning.
    Element block_element(const Tree&, NodeId) const;

    // ---- expression.cpp
    Value evaluate(const Tree&, NodeId);
    /// A number, or nothing when that has been reported. `what` and the word begin the message:
    /// "the argument of `sin`".
    std::optional<double> number(const Tree&, NodeId, std::string_view what, NameId word = no_name);
    Value unary(const Tree&, const node::Unary&, NodeId);
    Value binary(const Tree&, const node::Binary&, NodeId);
    Value choice(const Tree&, const node::Choice&);
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
    bool fill(ArrayData&, std::size_t dimension, std::size_t& next, Body, Span);
    /// Computed before the array is looked up: an index may call a macro that changes the array.
    std::optional<Indices> indices(const Tree&, NodeId first);
    /// The element that indices lead to, through arrays of arrays; null when reported.
    const Value* element(const Value& array, const Indices&, Span);
    Value* edit_element(Value& array, const Indices&, Span);
    /// The place of an element in its array, or nothing when reported; `used` moves past the
    /// indices that it took.
    std::optional<std::size_t> place(const ArrayData&, const Indices&, std::size_t& used, Span);
    bool check_array(const Value&, Span);
    /// An initialised element other than the one that the indices lead to, if one is found near it.
    const Value* other_element(const Value& array, const Indices&);

    // ---- call.cpp
    Value call(const Tree&, const node::Call&, NodeId);
    Value call_function(const Tree&, const node::Call&, NodeId);
    void receive(const Tree&, NodeId first, int count, const Value&);
    bool defined(const Tree&, NodeId target);
    void walk_arguments(const Tree&, NodeId first, FunctionRef<void(Value, Span)> take);
    /// Runs a macro; its elements go to `take`.
    Flow call_macro(const Tree&, const node::Call&, NodeId, Take take);
    struct Argument {
        Scope::Reference reference;  ///< cell null: by value
        Value value = Absence::nothing;
    };
    std::optional<std::vector<Argument>> arguments(const Tree&, const node::Call&, NodeId,
                                                   const MacroData&);
    bool argument(const Tree&, NodeId, Argument&);

    // ---- walk.cpp, directive.cpp, declare.cpp
    Flow walk(const Tree&, NodeId first, Take take);
    /// A list that #break cannot leave: a file, the content of a block.
    void walk_whole(const Tree&, NodeId first, Take take);
    /// One node of a list: gives the next one to go on with.
    Flow walk_one(const Tree&, NodeId, Take take);
    static bool is_directive(const Tree&, NodeId);
    Flow directive(const Tree&, NodeId, Take take);
    /// Counts one more step; reports when it is one too many.
    bool too_many_steps(Span);
    Flow branch(const Tree&, const node::If&, Take take);
    Flow loop_while(const Tree&, const node::While&, Take take);
    Flow loop_for(const Tree&, const node::For&, NodeId, Take take);
    Flow choose(const Tree&, const node::Switch&, Take take);
    bool condition(const Tree&, NodeId);
    void declare(const Tree&, const node::Declare&, NodeId);
    void declare_tuple(const Tree&, const node::Declare&, NodeId);
    void assign(const Tree&, NodeId target, Value value, bool local);
    Value right_side(const Tree&, NodeId);
    void undefine(const Tree&, NodeId target);
    void define_macro(const Tree&, const node::Macro&, NodeId);
    Flow include(const Tree&, const node::Include&, NodeId, Take take);
    const Tree* load(const std::string& name, Span);
    void speak(const Tree&, const node::Message&, NodeId);
    void set_version(const Tree&, const node::Version&, NodeId);

    // ---- files.cpp
    void open_file(const Tree&, const node::Open&, NodeId);
    void open_for_reading(DataFile&, Span);
    void open_for_writing(DataFile&, bool append, Span);
    /// The file behind a name; null when there is none, which has been reported.
    Handle<DataFile> open_file_named(const Tree&, NodeId);
    Handle<DataFile> open_file_named(NameId, Span);
    void close_file(const Tree&, const node::Close&, NodeId);
    void read_values(const Tree&, const node::Read&, NodeId);
    bool read_into(const Tree&, NodeId target, DataReader&);
    void write_values(const Tree&, const node::Write&, NodeId);
    void write_value(DataWriter&, const Value&, const std::optional<BinaryForm>&, Span);

    // ---- walk.cpp
    /// Hands the element of a value node to `take`, with channels that follow it (`Red filter .5`);
    /// gives the next node.
    NodeId take_value(const Tree&, NodeId, Take take);
    Flow take_vector(const Tree&, NodeId, Take take);

    Evaluator& evaluator;
    SourceStore& sources;
    Loader loader;  ///< knows what this run has written
    Names& names;
    Diagnostics& diagnostics;
    RunFacts facts;
    Meaning meaning;
    Limits limits;
    Scope scope;
    Frames frames;
    FunctionWorld world;
    std::vector<const FunctionInfo*> functions;  ///< by reserved word
    std::deque<Tree> trees;
    std::map<std::string, const Tree*> loaded;
    std::size_t include_depth = 0;
    std::uint64_t steps = 0;
    std::uint64_t written_bytes = 0;
    double version = 3.7;
    bool version_given = false;
    Span last_break;
    bool stopped_ = false;
    const char* stack_end = nullptr;  ///< how far down the stack may grow; null: unlimited
};
