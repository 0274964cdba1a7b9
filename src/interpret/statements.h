// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the evaluator that walks lists: it computes values, carries out directives, and
// passes on the elements that remain. Internal to the evaluator.
#pragma once

#include "interpret/context.h"
#include "interpret/indices.h"
#include "interpret/sink.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace candelabra {

/// How a list of elements was left.
enum class Flow {
    end,     ///< at its end
    broken,  ///< by #break
    stopped  ///< nothing more is evaluated
};

class Statements {
public:
    explicit Statements(Context& context) : context_(context) {}

    /// Parses and walks the main file. Memory that runs out is reported.
    void run(SourceId main);

    // ---- walk.cpp
    Flow walk(const Tree&, NodeId first, const Sink& take);
    /// Walks a list that #break cannot leave: a file, the content of a block.
    void walk_whole(const Tree&, NodeId first, const Sink& take);
    /// Walks one node of a list.
    Flow walk_one(const Tree&, NodeId, const Sink& take);
    static bool is_directive(const Tree&, NodeId);
    /// An element `{ ... }`.
    static Element braces_element(const Tree&, NodeId);

    // ---- declare.cpp
    void assign(const Tree&, NodeId target, Value&& value, bool local);
    /// The value of blocks, one or several in a row, or of a directive.
    Value right_side(const Tree&, NodeId);

private:
    void run_scene(SourceId main);
    /// Prepares for a walk over a tree.
    void learn(const Tree&);
    /// A block element as it is passed to the handlers.
    Element block_element(const Tree&, NodeId);
    Flow walk_from(const Tree&, NodeId& id, const Sink& take);
    /// Passes the element of a value node to `take`, with the channels that follow it
    /// (`Red filter .5`). Returns the next node.
    NodeId take_value(const Tree&, NodeId, const Sink& take);
    Flow take_vector(const Tree&, NodeId, const Sink& take);
    NodeId take_power(const Tree&, NodeId, const Sink& take);
    /// The call at the beginning of an expression that is no call, but a word of a block before the
    /// parentheses of its value: `along (A)*x`. no_node: there is none.
    NodeId word_before(const Tree&, NodeId, const Sink& take) const;
    /// Passes on that word, and then the value of the expression.
    Flow take_word(const Tree&, NodeId, NodeId call, const Sink& take);

    // ---- directive.cpp
    Flow directive(const Tree&, NodeId, const Sink& take);
    bool condition(const Tree&, NodeId);
    Flow branch(const Tree&, const node::If&, const Sink& take);
    /// The branch whose condition holds, or null.
    const node::Branch* taken_branch(const Tree&, const node::If&);
    Flow loop_while(const Tree&, const node::While&, const Sink& take);
    std::optional<std::array<double, 3>> for_range(const Tree&, const node::For&, NodeId);
    std::optional<double> counter(NameId, Span);
    Flow loop_for(const Tree&, const node::For&, NodeId, const Sink& take);
    Flow choose(const Tree&, const node::Switch&, const Sink& take);
    Flow include(const Tree&, const node::Include&, NodeId, const Sink& take);
    const Tree* load(const std::string& name, Span);
    void speak(const Tree&, const node::Message&, NodeId);
    void set_version(const Tree&, const node::Version&, NodeId);
    void check_version(const Tree&, NodeId, double asked);

    // ---- declare.cpp
    void declare(const Tree&, const node::Declare&, NodeId);
    NodeId declare_layers(const Tree&, const node::Declare&, NodeId next);
    void declare_deprecated(const Tree&, const node::Deprecated&, NodeId);
    void declare_tuple(const Tree&, const node::Declare&, NodeId);
    void declare_numbers(const Tree&, const node::Declare&, const Numbers&);
    /// Declares a string built by concat() or str(), in place if possible. Returns false, with no
    /// effect, for other values.
    bool declare_text(const Tree&, const node::Declare&);
    void check_semicolon(const Tree& tree, const node::Declare& node) {
        if (!node.semicolon) report_semicolon(tree, node);
    }
    void report_semicolon(const Tree&, const node::Declare&);
    void assign_element(const Tree&, const node::Index&, NodeId target, Value&& value);
    void undefine(const Tree&, NodeId target);

    Context& context_;
    std::size_t include_depth_ = 0;
    bool semicolons_reported_ = false;  ///< the rule of semicolons has been given
    Span last_break_;
};

}  // namespace candelabra
