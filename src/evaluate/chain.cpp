// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/chain.h"

#include "evaluate/state.h"

Value Evaluator::State::chain(const Tree& tree, const node::Chain& node) {
    struct Placed {
        Value value;
        Span span;
    };
    const auto joined = [&](Operator sign, Placed a, Placed b) -> Placed {
        const Span whole = join(a.span, b.span);
        return {combine(sign, std::move(a.value), std::move(b.value), b.span, whole), whole};
    };
    ChainTotal<Placed> total;
    const bool good =
        walk_chain(tree, node.first, [&](Operator sign, const Tree& from, NodeId operand) {
            total.add(sign, {evaluate(from, operand), from.span(operand)}, joined);
        });
    std::optional<Placed> result = total.result(joined);
    if (!good || stopped_ || !result) return Absence::broken;
    return std::move(result->value);
}

bool Evaluator::State::walk_chain(const Tree& tree, NodeId first,
                                  FunctionRef<void(Operator, const Tree&, NodeId)> take) {
    bool good = true;
    for (NodeId id = first; id != no_node && !stopped_; id = tree[id].next) {
        if (const auto* joined = tree.get_if<node::Joined>(id)) {
            take(joined->sign, tree, joined->operand);
        } else if (!is_directive(tree, id)) {
            take(Operator::add, tree, id);
        } else {
            walk_one(tree, id, [&](const Element& element) {
                if (element.kind == Element::Kind::joined) {
                    good = walk_chain(*element.body.tree, element.body.first, take) && good;
                    return;
                }
                good = false;
                report(error(Fault::wrong_count, element.span,
                             "there is no operator between this and the expression before it")
                           .pointing(tree.span(id), "which this directive goes on with")
                           .with_help("each part begins with +, -, * or /, or is empty"));
            });
        }
    }
    return good;
}
