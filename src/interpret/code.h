// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled numeric expressions. Each is a program that reads the names of the expression and
// computes its components one by one. For each tree the evaluator keeps a table of the code of its
// nodes. Compiling takes longer than evaluating once, so only nodes that are met again are
// compiled.
#pragma once

#include "formula/program.h"
#include "syntax/tree.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace candelabra {

/// One version of an expression's code, for the kinds that its names had when it was compiled.
struct Code {
    /// A name that is read first. Its value must have `count` numbers.
    struct Input {
        NameId name;
        std::uint16_t first;  ///< its first register
        std::uint16_t count;
    };
    /// A called function. Its name must still stand for it.
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
    int versions = 1;             ///< number of versions linked from here on
};

class CodeTable {
public:
    /// Must be called for a tree before its nodes are looked up.
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
    /// Whether compiling another version now is worthwhile. Counts the visits.
    bool wanted(const Tree&, NodeId);
    /// Adds a version of a node's code.
    Code* keep(const Tree&, NodeId, Code);
    /// Marks a node as one that cannot be compiled, whatever its names stand for.
    void exclude(const Tree&, NodeId);

private:
    // States of a node in nodes_.
    static constexpr std::uint32_t met = 1;       ///< once; up to `never`: compiled in vain
    static constexpr std::uint32_t never = 5;     ///< not to be compiled
    static constexpr std::uint32_t compiled = 8;  ///< and above: plus the index of its code
    static constexpr int max_versions = 4;

    std::uint32_t& state(const Tree& tree, NodeId id) {
        return nodes_[tree.source][static_cast<std::size_t>(id)];
    }

    std::vector<std::vector<std::uint32_t>> nodes_;  ///< by source and node
    std::vector<std::unique_ptr<Code>> codes_;
};

}  // namespace candelabra
