// SPDX-License-Identifier: GPL-3.0-or-later
// Walks lists of elements: computes values, carries out directives, and passes on the elements that
// remain.
#include "base/work_watch.h"
#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "syntax/lint.h"
#include "text/message.h"
#include "vocabulary/reserved.h"

#include <new>
#include <utility>

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

bool Statements::is_directive(const Tree& tree, NodeId id) {
    return tree[id].content.index() >= kind<node::Declare>;
}

Flow Statements::walk(const Tree& tree, NodeId first, const Sink& take) {
    NodeId id = first;
    try {
        return walk_from(tree, id, take);
    } catch (const WorkEnded&) {
        context_.costs.overspent(tree.span(id));
        return Flow::stopped;
    }
}

/// Walks the list from `id` on, which then is the node that is being walked.
Flow Statements::walk_from(const Tree& tree, NodeId& id, const Sink& take) {
    while (id != no_node) {
        if (context_.stopped()) return Flow::stopped;
        context_.costs.work += 10;  // the sum is checked now and then, elsewhere
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
    return context_.stopped() ? Flow::stopped : Flow::end;
}

/// Passes on `pwr(a, b)`, with its arguments as a vector. Returns the next node.
NodeId Statements::take_power(const Tree& tree, NodeId id, const Sink& take) {
    walk_one(tree, id, take);
    const NodeId arguments = tree[id].next;
    std::vector<double> numbers;
    const bool good =
        context_.expressions->components(tree, tree.get<node::Tuple>(arguments).content, numbers);
    take.value(good ? context_.expressions->vector_of(numbers, tree.span(arguments))
                    : Value(Absence::broken),
               tree, arguments);
    return tree[arguments].next;
}

Flow Statements::walk_one(const Tree& tree, NodeId id, const Sink& take) {
    if (!context_.room(tree, id)) return Flow::stopped;  // what it is given to may walk its body
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
            if (word_before(tree, id, take) == id) return take_word(tree, id, id, take);
            if (!context_.names.reserved(call.name) && !context_.calls->is_function(call.name))
                return context_.calls->call_macro(tree, call, id, take);
            take.value(context_.expressions->evaluate(tree, id), tree, id);
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
            if (const NodeId call = word_before(tree, id, take); call != no_node)
                return take_word(tree, id, call, take);
            take.value(context_.expressions->evaluate(tree, id), tree, id);
            return Flow::end;
    }
}

NodeId Statements::word_before(const Tree& tree, NodeId id, const Sink& take) const {
    if (!take.is_of_block()) return no_node;
    for (;;) {
        if (const auto* binary = tree.get_if<node::Binary>(id)) {
            id = binary->left;
        } else if (const auto* member = tree.get_if<node::Member>(id)) {
            id = member->operand;
        } else if (const auto* choice = tree.get_if<node::Choice>(id)) {
            id = choice->condition;
        } else {
            const auto* call = tree.get_if<node::Call>(id);
            const bool known = !call || context_.names.reserved(call->name) ||
                               context_.scope.find(call->name) ||
                               context_.calls->is_function(call->name);
            return !known && context_.handlers.knows_word(call->name) ? id : no_node;
        }
    }
}

Flow Statements::take_word(const Tree& tree, NodeId id, NodeId call, const Sink& take) {
    Element element;
    element.word = tree.get<node::Call>(call).name;
    element.origin = {&tree, call};
    element.span = tree.span(call);
    element.span.last = element.span.first +
                        static_cast<std::uint32_t>(context_.names.spelling(element.word).size());
    element.word_span = element.span;
    take(element);
    const Body around = std::exchange(context_.word_call, Body{&tree, call});
    Element value = Sink::value_element(context_.expressions->walk_expression(tree, id), tree, id);
    context_.word_call = around;
    value.span.first = value.word_span.first = element.span.last;
    take(value);
    return context_.stopped() ? Flow::stopped : Flow::end;
}

Element Statements::braces_element(const Tree& tree, NodeId id) {
    Element element;
    element.kind = Element::Kind::braces;
    element.body = {&tree, tree.get<node::Braces>(id).body};
    element.span = element.word_span = tree.span(id);
    element.origin = {&tree, id};
    return element;
}

/// Takes a list in `< >`. With six numbers or more it is not a value, but a list element.
Flow Statements::take_vector(const Tree& tree, NodeId id, const Sink& take) {
    Numbers computed;
    if (context_.expressions->compute(tree, id, computed)) {
        take.value(computed, tree, id);
        return Flow::end;
    }
    std::vector<double> numbers;
    if (!context_.expressions->components(tree, tree.get<node::Vector>(id).components, numbers)) {
        take.value(Absence::broken, tree, id);
        return context_.stopped() ? Flow::stopped : Flow::end;
    }
    Element element = Sink::value_element(Absence::nothing, tree, id);
    if (numbers.size() > 5) {
        element.kind = Element::Kind::list;
        element.list = numbers;
    } else {
        element.value = context_.expressions->vector_of(numbers, tree.span(id));
    }
    take(element);
    return Flow::end;
}

NodeId Statements::take_value(const Tree& tree, NodeId id, const Sink& take) {
    NodeId next = tree[id].next;
    Numbers computed;
    if (!tree.get_if<node::Name>(id) && !tree.get_if<node::Channel>(next) &&
        context_.expressions->compute(tree, id, computed)) {
        take.value(computed, tree, id);
        return next;
    }
    Element element = Sink::value_element(Absence::nothing, tree, id);
    Numbers channels;
    channels.count = 5;
    if (const auto* name = tree.get_if<node::Name>(id)) {
        element.word = name->name;
        if (!context_.expressions->value_named(name->name)) {
            // Perhaps a word that only the block around it knows.
            element.kind = Element::Kind::word;
            take(element);
            return next;
        }
        element.value = context_.expressions->evaluate(tree, id);
    } else if (const auto* channel = tree.get_if<node::Channel>(id)) {
        if (context_.expressions->set_channel(tree, *channel, channels))
            element.value = channels;
        else
            element.value = Absence::broken;
    } else {
        element.value = context_.expressions->evaluate(tree, id);
    }
    // Channels change the colour that they follow.
    for (; tree.get_if<node::Channel>(next); next = tree[next].next) {
        Numbers* colour = element.value.edit_numbers();
        if (!colour || !colour->is_colour()) break;
        if (!context_.expressions->set_channel(tree, tree.get<node::Channel>(next), *colour))
            element.value = Absence::broken;
        element.span = element.word_span = join(element.span, tree.span(next));
        element.word = no_name;
        element.origin = {};
    }
    take(element);
    return next;
}

void Statements::run(SourceId main) {
    // Released to have room for the message.
    auto reserve = std::make_unique<std::array<char, std::size_t{1} << 20>>();
    // Steps that objects, meshes and patterns count take longer than those of expressions.
    constexpr std::uint64_t each_step = 20;
    const WorkWatch* asking = nullptr;
    std::uint64_t counted = 0;
    const std::function<bool()> too_much = [&] {
        context_.costs.work +=
            each_step * (asking->counted() - std::exchange(counted, asking->counted()));
        return context_.costs.spent();
    };
    const WorkWatch watch(too_much);
    asking = &watch;
    try {
        run_scene(main);
    } catch (const WorkEnded&) {
        context_.costs.overspent({});
    } catch (const std::bad_alloc&) {
        reserve.reset();
        context_.stop();
        const std::vector<Frame> open = context_.frames.list(context_.names, context_.sources);
        const OpenLoop* loop = context_.costs.busiest_loop();
        Diagnostic problem = error(Fault::io,
                                   loop           ? loop->place()
                                   : open.empty() ? Span()
                                                  : open.front().called_at,
                                   "there is not enough memory to evaluate this scene");
        if (loop) problem.with_label(message("this loop has run ", loop->passes, " times"));
        context_.report(
            problem.with_help(loop ? "a loop that does not end needs a condition that becomes "
                                     "false, or #break; --limit-memory sets how much memory "
                                     "there may be"
                                   : "--limit-memory sets how much there may be"));
    }
}

void Statements::run_scene(SourceId main) {
    if (context_.handlers.set_version) context_.handlers.set_version(context_.version, {});
    context_.trees.deepest = context_.costs.limits.include_depth;
    const Tree& tree = context_.trees.main(main, context_.version);
    lint(tree, context_.names, context_.diagnostics);
    // A tree with holes would only give errors that follow from the first ones.
    if (context_.diagnostics.failed()) context_.stop();
    learn(tree);
    const auto take = [&](const Element& element) { context_.handlers.top(element); };
    if (!context_.stopped() && !context_.facts.header.empty()) {
        const std::string directory = directory_of(context_.sources.name(main));
        if (!context_.loader.load(context_.facts.header, directory)) {
            context_.report(
                context_.loader.problem(context_.facts.header, {}, FileKind::include, directory)
                    .with_note("Include_Header or +HI names it"));
            context_.stop();
            return;
        }
        if (const Tree* header = load(context_.facts.header, {main, 0, 0}))
            walk_whole(*header, header->first, take);
    }
    if (!context_.stopped()) walk_whole(tree, tree.first, take);
}

/// Prepares for a walk over a tree.
void Statements::learn(const Tree& tree) {
    context_.expressions->learn(tree);
    for (const ScopedName& each : tree.scoped)
        context_.scope.learn(each.whole, each.name, each.global);
}

void Statements::walk_whole(const Tree& tree, NodeId first, const Sink& take) {
    // Not inlined, so that nested objects do not each reserve stack for a message.
    const auto report_break = [this]() __attribute__((noinline)) {
        context_.report(error(Fault::misplaced, last_break_,
                              "this #break is in no loop, #switch or macro that it could leave"));
    };
    if (walk(tree, first, take) == Flow::broken) report_break();
}

Element Statements::block_element(const Tree& tree, NodeId id) {
    constexpr std::uint64_t reading = 60;
    context_.costs.work += reading;
    const auto& block = tree.get<node::Block>(id);
    Element element;
    element.kind = Element::Kind::block;
    element.word = block.word;
    element.body = {&tree, block.body};
    element.origin = {&tree, id};
    element.span = tree.span(id);
    const auto length = static_cast<std::uint32_t>(context_.names.spelling(block.word).size());
    element.word_span = {tree.source, element.span.first, element.span.first + length};
    return element;
}

}  // namespace candelabra
