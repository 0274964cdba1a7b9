// SPDX-License-Identifier: GPL-3.0-or-later
// Walks lists of elements: computes values, carries out directives, and passes on the elements that
// remain.
#include "base/work_watch.h"
#include "interpret/state.h"
#include "text/message.h"
#include "vocabulary/reserved.h"

namespace candelabra {

namespace {

/// Whether the node begins `pwr(a, b)`, the only word of a block that has arguments.
bool is_power(const Tree& tree, NodeId id) {
    const auto* word = tree.get_if<node::Word>(id);
    return word && word->word == "pwr"_word && tree.get_if<node::Tuple>(tree[id].next);
}

/// Whether a node is a value that channels follow, which may change it: `Red*0.8 filter 0.5`.
bool has_channels(const Tree& tree, const Node& node) {
    const std::size_t index = node.content.index();
    return index > kind<node::Word> && index < kind<node::Channel> && index != kind<node::Call> &&
           tree.get_if<node::Channel>(node.next);
}

}  // namespace

bool Evaluator::State::is_directive(const Tree& tree, NodeId id) {
    return tree[id].content.index() >= kind<node::Declare>;
}

Flow Evaluator::State::walk(const Tree& tree, NodeId first, const Sink& take) {
    NodeId id = first;
    try {
        return walk_from(tree, id, take);
    } catch (const WorkEnded&) {
        overspent(tree.span(id));
        return Flow::stopped;
    }
}

/// Walks the list from `id` on, which then is the node that is being walked.
Flow Evaluator::State::walk_from(const Tree& tree, NodeId& id, const Sink& take) {
    while (id != no_node) {
        if (stopped_) return Flow::stopped;
        work += 10;  // the sum is checked now and then, elsewhere
        const Node& node = tree[id];
        const std::size_t kind_here = node.content.index();
        if (kind_here == kind<node::Declare>) {
            const auto& declared = *std::get_if<node::Declare>(&node.content);
            declare(tree, declared, id);
            id = declared.semicolon || !tree.get_if<node::Block>(node.next)
                     ? node.next
                     : declare_layers(tree, declared, node.next);
        } else if (take.written() && !is_directive(tree, id)) {
            (*take.written())(tree, id);
            id = node.next;
        } else if (is_power(tree, id)) {
            id = take_power(tree, id, take);
        } else if (kind_here >= kind<node::Word> && kind_here != kind<node::Constant> &&
                   kind_here != kind<node::Channel> && !has_channels(tree, node)) {
            const Flow flow = walk_one(tree, id, take);
            if (flow != Flow::end) return flow;
            id = node.next;
        } else {
            id = take_value(tree, id, take);
        }
    }
    return stopped_ ? Flow::stopped : Flow::end;
}

/// Passes on `pwr(a, b)`, with its arguments as a vector. Returns the next node.
NodeId Evaluator::State::take_power(const Tree& tree, NodeId id, const Sink& take) {
    walk_one(tree, id, take);
    const NodeId arguments = tree[id].next;
    std::vector<double> numbers;
    const bool good = components(tree, tree.get<node::Tuple>(arguments).content, numbers);
    take.value(good ? vector_of(numbers, tree.span(arguments)) : Value(Absence::broken), tree,
               arguments);
    return tree[arguments].next;
}

Flow Evaluator::State::walk_one(const Tree& tree, NodeId id, const Sink& take) {
    const NodeContent& content = tree[id].content;
    const auto body_element = [&](Element::Kind kind, NodeId body) {
        Element element;
        element.kind = kind;
        element.body = {&tree, body};
        element.span = element.word_span = tree.span(id);
        take(element);
        return Flow::end;
    };
    switch (content.index()) {
        case kind<node::Word>: {
            Element element;
            element.word = std::get_if<node::Word>(&content)->word;
            element.span = element.word_span = tree.span(id);
            element.origin = {&tree, id};
            take(element);
            return Flow::end;
        }
        case kind<node::Block>:
            take(block_element(tree, id));
            return Flow::end;
        case kind<node::Layers>:
            for (NodeId block = std::get_if<node::Layers>(&content)->blocks; block != no_node;
                 block = tree[block].next)
                take(block_element(tree, block));
            return Flow::end;
        case kind<node::Entry>:
            return body_element(Element::Kind::entry, std::get_if<node::Entry>(&content)->body);
        case kind<node::Braces>:
            take(braces_element(tree, id));
            return Flow::end;
        case kind<node::Omitted>: {
            Element element;
            element.kind = Element::Kind::omitted;
            element.span = element.word_span = tree.span(id);
            element.origin = {&tree, id};
            take(element);
            return Flow::end;
        }
        case kind<node::Call>: {
            const auto& call = *std::get_if<node::Call>(&content);
            if (!names.reserved(call.name) && !is_function(call.name))
                return call_macro(tree, call, id, take);
            take.value(evaluate(tree, id), tree, id);
            return Flow::end;
        }
        case kind<node::Vector>:
            return take_vector(tree, id, take);
        case kind<node::Chain>:
            if (const NodeId first = std::get_if<node::Chain>(&content)->first;
                tree.get_if<node::Joined>(first))
                return body_element(Element::Kind::joined, first);
            [[fallthrough]];
        default:
            if (is_directive(tree, id)) return directive(tree, id, take);
            take.value(evaluate(tree, id), tree, id);
            return Flow::end;
    }
}

Element Evaluator::State::braces_element(const Tree& tree, NodeId id) {
    Element element;
    element.kind = Element::Kind::braces;
    element.body = {&tree, tree.get<node::Braces>(id).body};
    element.span = element.word_span = tree.span(id);
    element.origin = {&tree, id};
    return element;
}

/// Takes a list in `< >`. With six numbers or more it is not a value, but a list element.
Flow Evaluator::State::take_vector(const Tree& tree, NodeId id, const Sink& take) {
    Numbers computed;
    if (compute(tree, id, computed)) {
        take.value(computed, tree, id);
        return Flow::end;
    }
    std::vector<double> numbers;
    if (!components(tree, tree.get<node::Vector>(id).components, numbers)) {
        take.value(Absence::broken, tree, id);
        return stopped_ ? Flow::stopped : Flow::end;
    }
    Element element = Sink::value_element(Absence::nothing, tree, id);
    if (numbers.size() > 5) {
        element.kind = Element::Kind::list;
        element.list = numbers;
    } else {
        element.value = vector_of(numbers, tree.span(id));
    }
    take(element);
    return Flow::end;
}

NodeId Evaluator::State::take_value(const Tree& tree, NodeId id, const Sink& take) {
    NodeId next = tree[id].next;
    Numbers computed;
    if (!tree.get_if<node::Name>(id) && !tree.get_if<node::Channel>(next) &&
        compute(tree, id, computed)) {
        take.value(computed, tree, id);
        return next;
    }
    Element element = Sink::value_element(Absence::nothing, tree, id);
    Numbers channels;
    channels.count = 5;
    if (const auto* name = tree.get_if<node::Name>(id)) {
        element.word = name->name;
        if (!value_named(name->name)) {
            // Perhaps a word that only the block around it knows.
            element.kind = Element::Kind::word;
            take(element);
            return next;
        }
        element.value = evaluate(tree, id);
    } else if (const auto* channel = tree.get_if<node::Channel>(id)) {
        if (set_channel(tree, *channel, channels))
            element.value = channels;
        else
            element.value = Absence::broken;
    } else {
        element.value = evaluate(tree, id);
    }
    // Channels change the colour that they follow.
    for (; tree.get_if<node::Channel>(next); next = tree[next].next) {
        Numbers* colour = element.value.edit_numbers();
        if (!colour || !colour->is_colour()) break;
        if (!set_channel(tree, tree.get<node::Channel>(next), *colour))
            element.value = Absence::broken;
        element.span = element.word_span = join(element.span, tree.span(next));
        element.word = no_name;
        element.origin = {};
    }
    take(element);
    return next;
}

}  // namespace candelabra
