// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the evaluator that computes the values of expressions. Internal to the evaluator.
#pragma once

#include "interpret/array_data.h"
#include "interpret/code.h"
#include "interpret/context.h"
#include "interpret/indices.h"
#include "interpret/sink.h"

#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

class Expressions {
public:
    explicit Expressions(Context& context) : context_(context) {}

    /// Prepares for the expressions of a tree.
    void learn(const Tree& tree) { codes_.add(tree); }

    // ---- compute.cpp: the fast path for numbers
    /// Computes the numbers of an expression if nothing has to be reported. Otherwise returns
    /// false, without effects, and walk_expression() must do it.
    bool compute(const Tree&, NodeId, Numbers&);
    /// The number of an expression; nothing after a report. `what` and the word begin the message:
    /// "the argument of `sin`".
    std::optional<double> number(const Tree&, NodeId, std::string_view what, NameId word = no_name);

    // ---- expression.cpp
    Value evaluate(const Tree&, NodeId);
    /// evaluate() without an attempt to compute() first.
    Value walk_expression(const Tree&, NodeId);
    /// The value of the name, or null. A constant of newer versions counts where the scene declares
    /// no such name.
    const Value* value_named(NameId name) const {
        const Value* const found = context_.scope.find(name);
        return found || name != tau_ ? found : &value_of_tau_;
    }
    Value name_value(NameId, Span);
    /// The value in parentheses.
    Value group(const Tree&, NodeId content, Span);
    Value index_value(const Tree&, const node::Index&, NodeId);
    Value constant(NameId);
    Value combine(Operator, Value left, Value right, Span right_span, Span whole);
    Value vector_of(const std::vector<double>&, Span);
    bool components(const Tree&, NodeId first, std::vector<double>&);
    /// The calls of rand() in an expression, in order, except those in macros.
    std::vector<NodeId> random_calls(const Tree&, NodeId) const;
    /// The value of some elements, of which one value is expected.
    Value one_value(std::span<const Element>, Span);
    Value one_value(OneValue&&, Span);
    /// Reports that a macro yields no value, or several, where one is expected.
    Value report_count(std::size_t, Span);

    // ---- chain.cpp
    /// An unevaluated operand, and the operators before it. The sign of the first is add.
    struct Operand {
        Operator sign;
        bool negative;
        const Tree& tree;
        NodeId id;
        Span span;  ///< its place in the expression: the call, if it is of a macro
    };
    /// Walks the operands of an expression in order. Macros and directives among them are expanded
    /// as if their text stood there. Returns false after a report.
    bool walk_operands(const Tree&, NodeId, FunctionRef<void(const Operand&)> take);

    // ---- colours.cpp
    bool set_channel(const Tree&, const node::Channel&, Numbers&);

    // ---- array.cpp
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
    /// Makes a growing array as large as the indices need. Returns false after a report.
    bool make_room(Value& array, const Indices&, std::size_t used, Span);
    /// The position of an element in its array, or nothing after a report. Moves `used` past the
    /// indices that it used.
    std::optional<std::size_t> place(const ArrayData&, Indices&, std::size_t& used, Span);
    /// Reports a value that is no array.
    bool check_array(const Value&, Span);

    // ---- texts.cpp
    /// Whether the node is a call that append_text() can build.
    bool builds_text(const Tree& tree, NodeId id) const {
        const auto* call = tree.get_if<node::Call>(id);
        return call && (call->name == concat_ || call->name == str_) &&
               has_plain_arguments(tree, *call);
    }
    /// Appends the text of an argument of the function. Returns false after a report.
    bool append_text(const Tree&, NodeId, std::string& text, NameId function);
    bool append_texts(const Tree&, NodeId first, std::string& text, NameId function);
    bool is_concat(NameId name) const { return name == concat_; }

private:
    class OperandWalk;

    std::optional<double> compute_scalar(const Tree&, NodeId);
    /// Makes code of an expression; null if there can be none.
    Code* compile(const Tree&, NodeId);
    bool load(Code&) const;
    bool run(Code&, Numbers& result);
    /// The number of an expression that nearly always is one. If nothing, its value is `other`,
    /// which number_in() converts to a number or reports.
    std::optional<double> number_or(const Tree&, NodeId, Value& other);
    std::optional<double> number_in(const Value&, const Tree&, NodeId, std::string_view what,
                                    NameId word = no_name);

    /// Reports values with commas between where one is wanted. The value is broken.
    Value refuse_tuple(const Tree&, NodeId);
    /// Moves the values in parentheses to where a declaration waits for them.
    Value take_tuple(const Tree&, NodeId);
    Value refuse_gap(const Tree&, NodeId);
    Value unary(const Tree&, const node::Unary&, NodeId);
    Value with_sign(Operator, Value, Span);
    Value binary(const Tree&, const node::Binary&, NodeId);
    Value choice(const Tree&, const node::Choice&);
    /// Draws the random numbers that an expression would have drawn.
    void draw(const Tree&, NodeId);
    Value vector(const Tree&, const node::Vector&, NodeId);
    Value truth(const Value&, const Value&, Operator, Span);
    /// The value of an expression whose operands are walked one by one.
    Value open_expression(const Tree&, NodeId);

    Value member(const Tree&, const node::Member&, NodeId);
    Value prefixed(const Tree&, const node::Prefixed&, NodeId);
    Value colour(const Tree&, const node::Colour&, NodeId);

    Value array(const Tree&, const node::Array&, NodeId);
    bool fill(ArrayData&, std::size_t dimension, std::size_t& next, const Element& braces);
    bool fill_one(ArrayData&, std::size_t at, Value value, Span);
    bool refuse_in_array(const ArrayData&, const Element&);
    bool leave_out(ArrayData&, std::size_t dimension, std::size_t& next);
    /// Whether the element is a name that nothing is declared as.
    bool is_undeclared(const Element&) const;
    /// One index, checked against the size of its dimension; nothing after a report.
    std::optional<int> index_in(const ArrayData&, std::size_t dimension, Indices&,
                                std::size_t used);
    void report_unknown_name(const IndexNames*, const std::string& name, Span);

    bool has_plain_arguments(const Tree&, const node::Call&) const;
    bool append_number(const Tree&, NodeId first, std::string& text);
    /// The number of an argument of a function; nothing after a report.
    std::optional<double> number_argument(const Tree&, NodeId, NameId function);

    Context& context_;
    CodeTable codes_;
    const NameId tau_ = context_.names.intern("tau");
    const Value value_of_tau_ = 2 * std::numbers::pi;
    const NameId concat_ = context_.names.find("concat");
    const NameId str_ = context_.names.find("str");
};

}  // namespace candelabra
