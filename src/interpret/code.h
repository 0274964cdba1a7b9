// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions of numbers, compiled: each is a program that reads the names of the expression and
// computes its components one by one. Beside each tree the evaluator keeps a table of what was
// compiled for which node. Compiling takes longer than evaluating once, so it is done for nodes
// that are met again.
#pragma once

#include "formula/program.h"
#include "syntax/tree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace candelabra {

/// One way to compute an expression: for names of the kinds that it was compiled for.
struct Code {
    /// A name that is read first; it must stand for that many numbers.
    struct Input {
        NameId name;
        std::uint16_t first;  ///< its register
        std::uint16_t count;
    };
    /// A name that is called; it must still stand for this.
    struct Callee {
        NameId name;
        const void* function;
    };

    Program program;
    std::vector<double> registers;  ///< with the constants in place
    std::vector<Input> inputs;
    std::vector<Callee> callees;
    std::uint64_t cost = 0;       ///< see cost(Program)
    bool random = false;          ///< advances random streams
    std::unique_ptr<Code> other;  ///< for names of other kinds
    int versions = 1;             ///< how many are linked from here on
};

class CodeTable {
public:
    /// Must have been called for a tree before its nodes are asked for.
    void add(const Tree&);

    /// The newest code of an expression, or null.
    Code* find(const Tree& tree, NodeId id) const {
        const std::uint32_t state = nodes_[tree.source][static_cast<std::size_t>(id)];
        return state < compiled ? nullptr : codes_[state - compiled].get();
    }
    /// Whether no code can be made of the node.
    bool excluded(const Tree& tree, NodeId id) const {
        return nodes_[tree.source][static_cast<std::size_t>(id)] == never;
    }
    /// Whether it is worth while to compile one more version now. Counts the visits.
    bool wanted(const Tree&, NodeId);
    /// One more version for a node.
    Code* keep(const Tree&, NodeId, Code);
    /// No code can be made of this node, whatever its names stand for.
    void exclude(const Tree&, NodeId);

private:
    // What nodes_ says about a node.
    static constexpr std::uint32_t met = 1;       ///< once; until `never`: compiled in vain
    static constexpr std::uint32_t never = 5;     ///< not to be compiled
    static constexpr std::uint32_t compiled = 8;  ///< and more: the number of its code
    static constexpr int max_versions = 4;

    std::uint32_t& state(const Tree& tree, NodeId id) {
        return nodes_[tree.source][static_cast<std::size_t>(id)];
    }

    std::vector<std::vector<std::uint32_t>> nodes_;  ///< by source and node
    std::vector<std::unique_ptr<Code>> codes_;
};

}  // namespace candelabra
