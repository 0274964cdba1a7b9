// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles the body of a user function. Its language is smaller than that of other expressions:
// numbers only, comparisons without tolerance, and sum() and prod(). A name that has a value when
// the function is declared is a constant from then on. Used by user_function.cpp.
#pragma once

#include "formula/builder.h"
#include "formula/formula.h"
#include "formula/function_texts.h"
#include "interpret/context.h"
#include "text/message.h"

#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace candelabra {

struct FunctionCompiler {
    using Operand = ProgramBuilder::Operand;
    using Result = std::optional<Operand>;  ///< nothing: after a report

    explicit FunctionCompiler(Context& context) : context(context) {}

    void add_parameter(NameId name) { locals.push_back({name, builder.input()}); }

    // ---- the text of the function, if texts are kept
    /// The parts as one text; empty if texts are not kept.
    template <class... Parts>
    static std::string worded(const Parts&... parts) {
        return FunctionTexts::kept() ? message(parts...) : std::string();
    }
    /// Keeps the text of an operand, which may be taken once, or often if it `stays`.
    Operand said(Operand, std::string text, bool stays = false);
    /// The text of an operand; empty if texts are not kept.
    std::string text(Operand);
    /// The texts of several operands, with commas between them.
    std::string texts(std::span<const Operand>);
    /// The text of a call, without its arguments.
    std::string called_text(const Handle<Formula>&);
    /// Names the parameters; `listed`: in a list before the body.
    void name_parameters(std::size_t count, bool listed);
    /// The text of the whole. Precondition: name_parameters() has been called.
    FormulaText whole_text(Operand result);

    // ---- operators
    /// Compiles a list with directives and one expression.
    Result body(const Tree&, NodeId first, Span);
    void list(const Tree&, NodeId first, std::vector<Operand>& values);
    void take(const Tree&, NodeId, std::vector<Operand>& values);
    Result expression(const Tree&, NodeId);
    Result name(NameId, Span);
    Result constant(const Value&, std::string_view what, Span);
    Result unary(const Tree&, const node::Unary&, NodeId);
    Result binary(const Tree&, const node::Binary&, NodeId);
    Result negative(Result);
    /// Compiles an expression with macros or directives among its operands.
    Result open(const Tree&, NodeId);
    Result combine(const Tree&, Operator, Result a, Result b, NodeId right);
    Operand joined(Operation, std::string_view sign, Operand a, Operand b);
    Result logical(const Tree&, NodeId);
    Result division(const Tree&, Operand a, Operand b, NodeId divisor);
    Result wrong(Span, std::string message);

    // ---- calls
    /// A function that is called by its name or as an element of an array.
    struct Called {
        Handle<Formula> formula;
        NameId name;
        NodeId arguments;
    };
    /// The function that the node calls, null after a report; nothing for other nodes.
    std::optional<Called> called(const Tree&, NodeId);
    Result call(const Tree&, const node::Call&, NodeId);
    Result apply(const Tree&, const node::Apply&, NodeId);
    Result call_one(const Tree&, const Called&, NodeId);
    Result call_formula(const Tree&, const Called&, NodeId);
    Result member(const Tree&, const node::Member&, NodeId);
    Result part(std::string_view member, Operand first, std::size_t count);
    Result loop(const Tree&, const node::Call&, NodeId);
    Result function(const Tree&, const node::Call&, NodeId);
    Operand function_of_two(std::string_view name, Operand a, Operand b);
    std::optional<std::vector<Operand>> arguments(const Tree&, NodeId first);

    Context& context;
    ProgramBuilder builder;
    std::vector<std::pair<NameId, Operand>> locals;  ///< parameters and counters of loops
    struct Said {
        std::string text;
        bool stays;
    };
    std::unordered_map<Operand, Said> spoken;
    FormulaText whole;
    std::size_t counters = 0;  ///< of loops so far
};

}  // namespace candelabra
