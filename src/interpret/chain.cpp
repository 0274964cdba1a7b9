// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/chain.h"

#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "text/message.h"

namespace candelabra {

/// Splits an expression into operands. A macro stands for its text, and so does a part of a
/// directive: 2*Sum(1, 2) is 2*1 + 2 when Sum(A, B) is A+B without parentheses.
class Expressions::OperandWalk {
public:
    OperandWalk(Context& context, FunctionRef<void(const Operand&)> take)
        : context_(context), take_(take) {}

    /// `text`: the expression is the text of a macro or a directive.
    void expression(const Tree&, NodeId, bool text = false);
    /// False after a report.
    bool finish(Span);

private:
    void chain(const Tree&, NodeId first);
    void directive(const Tree&, NodeId);
    void macro(const Tree&, const node::Call&, NodeId);
    void operand(const Tree&, NodeId);
    void join(Operator sign);

    Context& context_;
    FunctionRef<void(const Operand&)> take_;
    std::optional<Operator> sign_ = Operator::add;  ///< operator before the next operand
    bool negative_ = false;                         ///< the next operand is negated
    std::optional<Span> call_;                      ///< the outermost open macro call
    bool good_ = true;
};

void Expressions::OperandWalk::expression(const Tree& tree, NodeId id, bool text) {
    if (!context_.room(tree, id)) return;
    const NodeContent& content = tree[id].content;
    const auto* binary = std::get_if<node::Binary>(&content);
    if (binary && (binary->open || (text && binary->sign <= Operator::divide))) {
        expression(tree, binary->left, text);
        join(binary->sign);
        expression(tree, binary->right, text);
    } else if (const auto* unary = std::get_if<node::Unary>(&content);
               unary && unary->sign != Operator::no) {
        negative_ ^= unary->sign == Operator::minus;
        expression(tree, unary->operand, text);
    } else if (const auto* chain = std::get_if<node::Chain>(&content)) {
        this->chain(tree, chain->first);
    } else if (const auto* call = context_.calls->macro_call(tree, id)) {
        macro(tree, *call, id);
    } else if (Statements::is_directive(tree, id)) {
        directive(tree, id);
    } else if (!std::get_if<node::Nothing>(&content)) {
        operand(tree, id);
    }
}

/// Takes an operator. After another operator it is the sign of the next operand.
void Expressions::OperandWalk::join(Operator sign) {
    if (sign_ && (sign == Operator::add || sign == Operator::subtract))
        negative_ ^= sign == Operator::subtract;
    else
        sign_ = sign;
}

void Expressions::OperandWalk::chain(const Tree& tree, NodeId first) {
    for (NodeId id = first; id != no_node && !context_.stopped(); id = tree[id].next) {
        const auto* joined = tree.get_if<node::Joined>(id);
        if (joined) join(joined->sign);
        expression(tree, joined ? joined->operand : id);
    }
}

void Expressions::OperandWalk::directive(const Tree& tree, NodeId id) {
    const auto take = [&](const Tree& from, NodeId part) { expression(from, part, true); };
    context_.statements->walk_one(tree, id, Sink(Sink::Written(take)));
}

void Expressions::OperandWalk::macro(const Tree& tree, const node::Call& call, NodeId id) {
    std::size_t count = 0;
    const auto take = [&](const Tree& from, NodeId part) {
        if (count++ == 0) expression(from, part, true);
    };
    const std::size_t errors = context_.diagnostics.error_count();
    const bool outermost = !call_;
    if (outermost) call_ = tree.span(id);
    context_.calls->call_macro(tree, call, id, Sink(Sink::Written(take)));
    if (outermost) call_.reset();
    if (count == 1) return;
    good_ = false;
    if (context_.diagnostics.error_count() == errors)
        context_.expressions->report_count(count, tree.span(id));
}

void Expressions::OperandWalk::operand(const Tree& tree, NodeId id) {
    const bool joined = sign_.has_value();
    if (joined) take_({*sign_, negative_, tree, id, call_.value_or(tree.span(id))});
    sign_.reset();
    negative_ = false;
    if (joined) return;
    good_ = false;
    context_.report(
        error(Fault::wrong_count, tree.span(id),
              "there is no operator between this and the expression before it")
            .with_help("in an expression, the parts of a directive are joined by +, -, * "
                       "and /"));
}

bool Expressions::OperandWalk::finish(Span span) {
    if (sign_ && good_ && !context_.stopped()) {
        good_ = false;
        context_.report(error(Fault::missing, span, "an operator in this has no value behind it")
                            .with_help("where a part of a directive ends in an operator, a value "
                                       "follows: #if (A) 2 * #end 3"));
    }
    return good_ && !context_.stopped();
}

bool Expressions::walk_operands(const Tree& tree, NodeId id,
                                FunctionRef<void(const Operand&)> take) {
    OperandWalk walk(context_, take);
    walk.expression(tree, id);
    return walk.finish(tree.span(id));
}

Value Expressions::open_expression(const Tree& tree, NodeId id) {
    struct Placed {
        Value value;
        Span span;
    };
    const auto joined = [&](Operator sign, Placed a, Placed b) -> Placed {
        const Span whole = join(a.span, b.span);
        return {combine(sign, std::move(a.value), std::move(b.value), b.span, whole), whole};
    };
    ChainTotal<Placed> total;
    const bool good = walk_operands(tree, id, [&](const Operand& operand) {
        Value value = evaluate(operand.tree, operand.id);
        if (operand.negative) value = with_sign(Operator::minus, std::move(value), operand.span);
        total.add(operand.sign, {std::move(value), operand.span}, joined);
    });
    std::optional<Placed> result = total.result(joined);
    if (!good || !result) return Absence::broken;
    return std::move(result->value);
}

}  // namespace candelabra
