// SPDX-License-Identifier: GPL-3.0-or-later
// Compiles one numeric expression to a program. Only compute.cpp uses it. A program has no effects
// except that random streams advance and that trace() stores a normal. A program that meets a case
// to be reported (a division by zero, a missing element) gives up, and the expression is walked
// instead. Vectors are computed component by component.
#pragma once

#include "formula/builder.h"
#include "formula/formula.h"
#include "interpret/code.h"
#include "interpret/context.h"

#include <utility>

namespace candelabra {

/// The components of a value of the program; none if it cannot be compiled.
struct Operands {
    std::size_t count = 0;
    std::array<ProgramBuilder::Operand, 5> at{};

    static Operands one(ProgramBuilder::Operand operand) { return {1, {operand}}; }
};

/// The operations of a binary operator. `tolerant` is for expressions, where very close numbers are
/// equal and a division by zero is reported; `exact` is for functions.
struct OperatorCode {
    Operation tolerant, exact;
};
/// Precondition: the operator is binary.
OperatorCode operations_of(Operator);

struct ExpressionCompiler {
    using Operand = ProgramBuilder::Operand;

    ExpressionCompiler(Context& context, CodeTable& codes, const Tree& tree, Code& code)
        : context(context), codes(codes), tree(tree), code(code) {}

    // ---- operators
    Operands compile(NodeId);
    Operands never();
    Operands numbers(std::span<const double> values);
    Operands name(NameId);
    Operands constant(NameId);
    Operands unary(const node::Unary&);
    Operands binary(const node::Binary&);
    Operands choice(const node::Choice&);
    Operands vector(const node::Vector&);
    Operands member(const node::Member&);
    Operands prefixed(const node::Prefixed&);
    /// Draws the random numbers that an expression would have drawn.
    bool draw(NodeId);
    /// Returns at least `count` components: a single one is copied to all, others get zeros.
    Operands promoted(const Operands&, std::size_t count);
    Operands with_zeros(const Operands&, std::size_t count);
    /// Releases operands that are not read any more.
    void release(const Operands&);
    void refuse_unless(Operand condition);

    // ---- calls
    Operands call(const node::Call&);
    Operands index(const node::Index&);
    Operands call_formula(Handle<Formula>, NodeId arguments);
    Operands random(NodeId arguments);
    Operands array_size(std::string_view name, NodeId arguments);
    bool scalars(NodeId first, std::vector<Operand>& result);
    bool indices_of(const ArrayData&, NodeId first, std::vector<Operand>& result, bool& named);
    Operands of_one(std::string_view name, std::uint16_t function, NodeId arguments);
    Operands of_numbers(std::string_view name, NodeId arguments);
    Operands of_vectors(std::string_view name, NodeId arguments);
    Operands of_object(std::string_view name, NodeId arguments);
    Operands trace(NameId object, NameId normal, std::span<const Operand> ray);
    Operands of_two_vectors(std::string_view name, const Operands& a, const Operands& b);
    /// A call of C++ code.
    template <class Code>
    Operands native(std::size_t results, Code code, std::span<const Operand> arguments) {
        return call_program(make_handle<Formula>(arguments.size(), results, std::move(code)),
                            arguments);
    }
    Operands call_program(Handle<Formula>, std::span<const Operand> arguments);
    void refuse_outside(std::string_view function, Operand x);
    Operand dot(const Operands& a, const Operands& b);

    Context& context;
    CodeTable& codes;
    const Tree& tree;
    Code& code;
    ProgramBuilder builder;
    std::vector<std::pair<NameId, Operands>> loaded;  ///< names and their inputs
    int depth = 0;
    bool hopeless = false;  ///< cannot be compiled, whatever its names stand for
};

}  // namespace candelabra
